// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>

#include <decoder/decode.h>

namespace decoder {
namespace {

using protocol::ImageAnswer;
using protocol::ImageFault;

constexpr int kWidth = 3;
constexpr int kHeight = 2;
const std::vector<float> kValues{0, 1, -2, std::numeric_limits<float>::infinity(), 65504, 0.5F};

std::string exr(const std::vector<std::string> &names, Imf::PixelType type,
                Imath::V2i corner = {0, 0}) {
    const Imath::Box2i window(corner, corner + Imath::V2i(kWidth - 1, kHeight - 1));
    Imf::Header header(window, window);
    header.insert("integrator", Imf::StringAttribute("direct_ems"));
    std::vector<float> floats = kValues;
    std::vector<half> halves(kValues.begin(), kValues.end());
    Imf::FrameBuffer buffer;
    for (const std::string &name : names) {
        header.channels().insert(name, Imf::Channel(type));
        if (type == Imf::FLOAT)
            buffer.insert(name, Imf::Slice::Make(type, floats.data(), window));
        else
            buffer.insert(name, Imf::Slice::Make(type, halves.data(), window));
    }
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(kHeight);
    }
    return stream.str();
}

std::string png(png_uint_32 format, const std::vector<png_byte> &bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = 2;
    image.height = 1;
    image.format = format;
    png_alloc_size_t size = 0;
    png_image_write_get_memory_size(image, size, 0, bytes.data(), 0, nullptr);
    std::string file(size, '\0');
    png_image_write_to_memory(&image, file.data(), &size, 0, bytes.data(), 0, nullptr);
    file.resize(size);
    return file;
}

ImageAnswer decoded(const std::string &bytes) {
    return decode(bytes.data(), bytes.size());
}

TEST(Decode, ReadsEveryChannelOfAnExrInFloats) {
    for (const Imf::PixelType type : {Imf::FLOAT, Imf::HALF}) {
        const ImageAnswer answer = decoded(exr({"variance.R", "R", "count.Y"}, type));
        ASSERT_EQ(answer.fault, ImageFault{}) << answer.message;
        EXPECT_EQ(answer.image.format, "exr");
        EXPECT_EQ(answer.image.width, kWidth);
        EXPECT_EQ(answer.image.height, kHeight);
        ASSERT_EQ(answer.image.channels.size(), 3U);
        for (const char *name : {"R", "count.Y", "variance.R"})
            EXPECT_EQ(answer.image.channel(name)->values, kValues) << name;
        EXPECT_EQ(answer.image.attributes.at("integrator"), "direct_ems");
    }
}

TEST(Decode, ReadsADataWindowThatDoesNotBeginAtTheOrigin) {
    const ImageAnswer answer = decoded(exr({"R"}, Imf::FLOAT, {-7, 1000}));
    ASSERT_EQ(answer.fault, ImageFault{}) << answer.message;
    EXPECT_EQ(answer.image.channel("R")->values, kValues);
}

TEST(Decode, UndoesTheCurveOfAPng) {
    const ImageAnswer answer = decoded(png(PNG_FORMAT_RGB, {255, 0, 188, 128, 10, 1}));
    ASSERT_EQ(answer.fault, ImageFault{}) << answer.message;
    EXPECT_EQ(answer.image.format, "png");
    ASSERT_EQ(answer.image.channels.size(), 3U);
    // IEC 61966-2-1
    const auto linear = [](double v) {
        v /= 255;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    const double expected[3][2] = {{1, linear(128)}, {0, linear(10)}, {linear(188), linear(1)}};
    for (int c = 0; c < 3; ++c) {
        const auto &values = answer.image.channel(std::string(1, "RGB"[c]))->values;
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(double{values[i]}, expected[c][i], 1e-6) << c << ' ' << i;
    }
}

TEST(Decode, ReadsGreyAndTransparentPngs) {
    const ImageAnswer grey = decoded(png(PNG_FORMAT_GRAY, {255, 0}));
    ASSERT_EQ(grey.fault, ImageFault{}) << grey.message;
    for (const char *name : {"R", "G", "B"})
        EXPECT_EQ(grey.image.channel(name)->values, (std::vector<float>{1, 0}));
    const ImageAnswer clear = decoded(png(PNG_FORMAT_RGBA, {255, 255, 255, 0, 0, 0, 0, 255}));
    ASSERT_EQ(clear.fault, ImageFault{}) << clear.message;
    EXPECT_EQ(clear.image.channel("A")->values, (std::vector<float>{0, 1}));
}

TEST(Decode, SaysWhatIsNoImage) {
    for (const std::string &bytes : {std::string(), std::string("GIF89a"), std::string("\x76\x2f"),
                                     std::string("\x89PNG\r\n\x1a", 7)})
        EXPECT_EQ(decoded(bytes).fault, ImageFault::NotAnImage);
    EXPECT_EQ(decoded("").message, "the file is empty");
}

TEST(Decode, TakesNoFileThatIsCutShort) {
    for (const std::string &bytes :
         {exr({"R", "G"}, Imf::FLOAT), png(PNG_FORMAT_RGB, {1, 2, 3, 4, 5, 6})}) {
        for (std::size_t size = 8; size + 12 < bytes.size(); ++size) { // PNG's end mark may miss
            const ImageAnswer answer = decoded(std::string(bytes, 0, size));
            EXPECT_EQ(answer.fault, ImageFault::Broken) << size << ": " << answer.message;
        }
    }
}

TEST(Decode, SurvivesAnyDamagedByte) {
    for (const std::string &bytes :
         {exr({"R", "G"}, Imf::HALF), png(PNG_FORMAT_RGB, {1, 2, 3, 4, 5, 6})}) {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            for (const char flip : {'\x01', '\x80', '\xff'}) {
                std::string damaged = bytes;
                damaged[i] = static_cast<char>(damaged[i] ^ flip);
                const ImageAnswer answer = decoded(damaged);
                EXPECT_TRUE(answer.fault != ImageFault{} || !answer.image.channels.empty());
            }
        }
    }
}

TEST(Decode, RefusesWhatWouldFillTheMemory) {
    std::string bytes = exr({"R"}, Imf::FLOAT);
    const std::string type("dataWindow\0box2i\0\x10\0\0\0", 21);
    const std::size_t at = bytes.find(type);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at + type.size() + 8, 8, std::string("\xff\xff\x3f\0\xff\xff\x3f\0", 8)); // 2^22
    EXPECT_NE(decoded(bytes).fault, ImageFault{});
    EXPECT_THROW(requireSize(20'000, 5'001, 1), DecodeError);
    EXPECT_THROW(requireSize(std::int64_t{1} << 40, std::int64_t{1} << 40, 1), DecodeError);
    EXPECT_THROW(requireSize(0, 1, 1), DecodeError);
    EXPECT_THROW(requireSize(1, 1, 0), DecodeError);
    EXPECT_NO_THROW(requireSize(20'000, 5'000, 1));
}

} // namespace
} // namespace decoder
