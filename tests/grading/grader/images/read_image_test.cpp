// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/images/read_image.h>
#include <grader/text_file.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

using protocol::ImageFault;

/// Decodes with whatever box this machine gives, and without one.
class ReadImage : public testing::TestWithParam<SandboxLevel> {
protected:
    static const std::filesystem::path &sky() {
        static const std::filesystem::path file =
            std::filesystem::path(NORI_SOURCE_DIR) / "scenes/assignment-2/serapis/sky.exr";
        return file;
    }

    Sandbox m_sandbox{GetParam()};
};

TEST_P(ReadImage, GivesTheChannelsOfAFile) {
    const protocol::Image image = readImage(m_sandbox, sky());
    EXPECT_EQ(image.format, "exr");
    EXPECT_EQ(image.width, 2 * image.height);
    for (const char *name : {"R", "G", "B"})
        EXPECT_NE(image.channel(name), nullptr) << name;
}

TEST_P(ReadImage, NamesTheFileAndWhatIsWrongWithIt) {
    const auto messageOf = [&](const std::filesystem::path &file) -> std::string {
        try {
            readImage(m_sandbox, file);
        } catch (const GraderError &error) {
            return error.what();
        }
        return {};
    };
    EXPECT_EQ(messageOf("/none/a.exr"), "/none/a.exr: no such file");
    const std::string text = NORI_SOURCE_DIR "/README.md";
    EXPECT_EQ(messageOf(text), text + ": neither an OpenEXR nor a PNG file");
    const std::string folder = NORI_SOURCE_DIR;
    EXPECT_EQ(messageOf(folder), folder + ": cannot be read");
}

INSTANTIATE_TEST_SUITE_P(Levels, ReadImage, testing::Values(SandboxLevel::S3, SandboxLevel::S0),
                         [](const auto &test) { return sandboxLevelName(test.param); });

TEST(DecodeImage, TellsABrokenFileFromAnImage) {
    const Sandbox sandbox;
    const std::string bytes = readTextFile(std::filesystem::path(NORI_SOURCE_DIR) /
                                           "scenes/assignment-2/serapis/sky.exr");
    EXPECT_TRUE(std::holds_alternative<protocol::Image>(decodeImage(sandbox, bytes)));
    const ImageReading half = decodeImage(sandbox, bytes.substr(0, bytes.size() / 2));
    ASSERT_TRUE(std::holds_alternative<NoImage>(half));
    EXPECT_EQ(std::get<NoImage>(half).fault, ImageFault::Broken);
}

} // namespace
} // namespace grader
