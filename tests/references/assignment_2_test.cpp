// SPDX-License-Identifier: MIT
#include <grader/references/references.h>

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = fs::path(NORI_SOURCE_DIR) / "scenes" / "assignment-2";
const fs::path kFolder = fs::path(NORI_SOURCE_DIR) / "references" / "assignment-2";
constexpr std::uintmax_t kLargestFolder = 60'000'000;

std::string attribute(const Imf::Header &header, const char *name) {
    return header.typedAttribute<Imf::StringAttribute>(name).value();
}

TEST(ReferencesOfAssignment2, AreThoseOfTheScenesAsTheyAre) {
    const std::vector<ReferenceImage> manifest = readManifest(kFolder);
    std::size_t count = 0;
    for (const SceneFile &scene : readSceneFiles(kScenes)) {
        for (const ReferenceImage &wanted : planReference(scene, kReferenceWidth)) {
            ++count;
            const bool found =
                std::any_of(manifest.begin(), manifest.end(), [&](const ReferenceImage &image) {
                    return isSameRender(image, wanted);
                });
            EXPECT_TRUE(found) << wanted.file << ": render it anew with `./run references`";
        }
    }
    EXPECT_EQ(manifest.size(), count) << "the manifest lists what no scene asks for";
}

TEST(ReferencesOfAssignment2, AreTheFilesThatTheManifestDescribes) {
    std::set<std::string> known{"manifest.toml"};
    for (const ReferenceImage &image : readManifest(kFolder)) {
        EXPECT_EQ(faultOf(kFolder, image), "");
        known.insert(image.file);
    }
    std::uintmax_t bytes = 0;
    for (const auto &entry : fs::recursive_directory_iterator(kFolder)) {
        if (!entry.is_regular_file())
            continue;
        EXPECT_EQ(known.count(entry.path().lexically_relative(kFolder).string()), 1u)
            << entry.path();
        bytes += entry.file_size();
    }
    EXPECT_LT(bytes, kLargestFolder);
}

TEST(ReferencesOfAssignment2, HoldMomentsAndSayWhatTheManifestSays) {
    std::set<int> seeds;
    for (const ReferenceImage &image : readManifest(kFolder)) {
        SCOPED_TRACE(image.file);
        const Imf::InputFile file((kFolder / image.file).c_str());
        const Imf::Header &header = file.header();
        EXPECT_EQ(attribute(header, "spp"), std::to_string(image.samplesPerPixel));
        EXPECT_EQ(attribute(header, "seed"), std::to_string(image.seed));
        EXPECT_EQ(attribute(header, "version"), image.version);
        EXPECT_EQ(attribute(header, "partial"), "no");
        EXPECT_EQ(header.dataWindow().max.x + 1, image.width);
        EXPECT_EQ(header.dataWindow().max.y + 1, image.height);
        for (const char *name : {"R", "mean.R", "variance.G", "third.B", "count.Y"})
            EXPECT_NE(header.channels().findChannel(name), nullptr) << name;
        EXPECT_TRUE(seeds.insert(image.seed).second) << "a seed is used twice";
    }
}

} // namespace
} // namespace grader
