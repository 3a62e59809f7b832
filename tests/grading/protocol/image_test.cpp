// SPDX-License-Identifier: MIT
#include <protocol/image.h>

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

namespace protocol {
namespace {

ImageAnswer sample() {
    ImageAnswer answer;
    answer.image = {"exr", 2, 1, {{"G", {1, 2}}, {"R", {3, 4}}}, {{"spp", "16"}}};
    return answer;
}

ImageAnswer decoded(const std::string &bytes) {
    return decodeImageAnswer(bytes.data(), bytes.size());
}

TEST(ImageAnswer, IsReadAsItWasWritten) {
    const ImageAnswer answer = decoded(encode(sample()));
    EXPECT_EQ(answer.fault, ImageFault{});
    EXPECT_EQ(answer.image.format, "exr");
    EXPECT_EQ(answer.image.width, 2);
    EXPECT_EQ(answer.image.height, 1);
    ASSERT_NE(answer.image.channel("R"), nullptr);
    EXPECT_EQ(answer.image.channel("R")->values, (std::vector<float>{3, 4}));
    EXPECT_EQ(answer.image.channel("B"), nullptr);
    EXPECT_EQ(answer.image.attributes.at("spp"), "16");
}

TEST(ImageAnswer, CarriesAFault) {
    ImageAnswer failed;
    failed.fault = ImageFault::Broken;
    failed.message = "the file ends too early";
    const ImageAnswer answer = decoded(encode(failed));
    EXPECT_EQ(answer.fault, ImageFault::Broken);
    EXPECT_EQ(answer.message, failed.message);
}

TEST(ImageAnswer, IsRefusedWhereItContradictsItself) {
    const std::function<void(ImageAnswer &)> mistakes[] = {
        [](ImageAnswer &a) { a.image.width = 3; },
        [](ImageAnswer &a) { a.image.width = -2; },
        [](ImageAnswer &a) { a.image.height = 1 << 30; },
        [](ImageAnswer &a) { a.image.channels.clear(); },
        [](ImageAnswer &a) { a.image.channels[1].values.pop_back(); },
        [](ImageAnswer &a) { a.image.channels[1].name = "G"; },
        [](ImageAnswer &a) { std::swap(a.image.channels[0], a.image.channels[1]); },
        [](ImageAnswer &a) { a.fault = ImageFault::Broken; },
        [](ImageAnswer &a) { a.fault = ImageFault{77}; },
    };
    for (const auto &make : mistakes) {
        ImageAnswer wrong = sample();
        make(wrong);
        EXPECT_THROW(decoded(encode(wrong)), std::runtime_error);
    }
}

TEST(ImageAnswer, IsRefusedWhenItIsCutShortOrTooLong) {
    const std::string bytes = encode(sample());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_THROW(decoded(std::string(bytes, 0, size)), std::runtime_error) << size;
    }
    EXPECT_THROW(decoded(bytes + '\0'), std::runtime_error);
}

TEST(ImageAnswer, SurvivesAnyFlippedByte) {
    const std::string bytes = encode(sample());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string flipped = bytes;
        flipped[i] = static_cast<char>(flipped[i] ^ 0x80);
        try {
            decoded(flipped);
        } catch (const std::runtime_error &) {
            continue; // what it is for
        }
    }
}

} // namespace
} // namespace protocol
