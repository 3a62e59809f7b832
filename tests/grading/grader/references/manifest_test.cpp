// SPDX-License-Identifier: MIT
#include <grader/digest.h>
#include <grader/error.h>
#include <grader/references/manifest.h>
#include <support/work_folder.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

ReferenceImage sampleImage() {
    return {"ñ/a_b.exr", "ñ/a.xml", "5ce9e", "direct_ems", 1024,
            2147483647,  256,       192,     "nori 1",     sha256Hex("pixels")};
}

TEST(Manifest, IsReadAsItWasWritten) {
    const support::WorkFolder folder;
    EXPECT_TRUE(readManifest(folder.path()).empty());
    writeManifest(folder.path(), {sampleImage(), sampleImage()});
    const std::vector<ReferenceImage> images = readManifest(folder.path());
    ASSERT_EQ(images.size(), 2u);
    EXPECT_TRUE(isSameRender(images[1], sampleImage()));
    EXPECT_EQ(images[1].version, "nori 1");
    EXPECT_EQ(images[1].sha256, sampleImage().sha256);
}

TEST(Manifest, SaysInWhichLineItIsDamaged) {
    const std::pair<const char *, const char *> cases[] = {
        {"", "lists no [[image]]"},
        {"\n[[image]]\nfile = 3\n", "manifest.toml:2: the text \"file\" is missing"},
        {"[[image]]\nfile = 'a'\nscene = 'a'\nscene_digest = ''\nintegrator = ''\nspp = -1\n",
         "the integer \"spp\" is missing"},
        {"a = 1\nb = \n", "manifest.toml:2:5: "},
        {"image = [1]\n", "is no table"}};
    for (const auto &[text, message] : cases) {
        const support::WorkFolder folder;
        folder.write("manifest.toml", text);
        try {
            readManifest(folder.path());
            ADD_FAILURE() << text;
        } catch (const GraderError &error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
        }
    }
}

TEST(Manifest, TellsAnotherRenderFromTheSame) {
    const ReferenceImage image = sampleImage();
    ReferenceImage other = image;
    other.version = "nori 2";
    other.sha256 = "";
    EXPECT_TRUE(isSameRender(image, other));
    other.seed = 1;
    EXPECT_FALSE(isSameRender(image, other));
    other = image;
    other.sceneDigest = "";
    EXPECT_FALSE(isSameRender(image, other));
    other = image;
    other.height = 1;
    EXPECT_FALSE(isSameRender(image, other));
}

TEST(Manifest, NoticesFilesThatAreMissingOrAltered) {
    const support::WorkFolder folder;
    EXPECT_NE(faultOf(folder.path(), sampleImage()).find("is missing"), std::string::npos);
    folder.write(sampleImage().file, "pixels");
    EXPECT_EQ(faultOf(folder.path(), sampleImage()), "");
    folder.write(sampleImage().file, "pixelz");
    EXPECT_NE(faultOf(folder.path(), sampleImage()).find("is not the file"), std::string::npos);
}

} // namespace
} // namespace grader
