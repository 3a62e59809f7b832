// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>

#include <cstring>

#include <decoder/decode.h>

namespace decoder {

using protocol::Image;
using protocol::ImageFault;

namespace {

/// The file's bytes for the library.
class MemoryStream : public Imf::IStream {
public:
    MemoryStream(const char *data, std::uint64_t size)
        : Imf::IStream("the file"), m_data(data), m_size(size) {}

    bool read(char bytes[], int count) override {
        const auto wanted = static_cast<std::uint64_t>(count);
        if (count < 0 || m_at > m_size || wanted > m_size - m_at)
            throw DecodeError(ImageFault::Broken, "the file ends too early");
        std::memcpy(bytes, m_data + m_at, wanted);
        m_at += wanted;
        return m_at < m_size;
    }

    std::uint64_t tellg() override { return m_at; }

    void seekg(std::uint64_t position) override { m_at = position; }

private:
    const char *m_data;
    std::uint64_t m_size;
    std::uint64_t m_at = 0;
};

std::map<std::string, std::string> textAttributes(const Imf::Header &header) {
    std::map<std::string, std::string> attributes;
    for (auto it = header.begin(); it != header.end(); ++it) {
        const Imf::Attribute &attribute = it.attribute();
        if (const auto *text = dynamic_cast<const Imf::StringAttribute *>(&attribute))
            attributes[it.name()] = text->value();
        else if (const auto *number = dynamic_cast<const Imf::IntAttribute *>(&attribute))
            attributes[it.name()] = std::to_string(number->value());
        else if (const auto *fraction = dynamic_cast<const Imf::FloatAttribute *>(&attribute))
            attributes[it.name()] = std::to_string(fraction->value());
    }
    return attributes;
}

} // namespace

Image decodeExr(const char *data, std::size_t size) {
    MemoryStream stream(data, size);
    Imf::InputFile file(stream, 0); // in this thread
    const Imf::Header &header = file.header();
    if (header.hasType() && Imf::isDeepData(header.type()))
        throw DecodeError(ImageFault::Unsupported, "deep images are not read");

    const Imath::Box2i window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    std::size_t count = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it, ++count) {
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
            throw DecodeError(ImageFault::Unsupported,
                              std::string("channel ") + it.name() + " is subsampled");
    }
    requireSize(width, height, count);

    Image image;
    image.format = "exr";
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.attributes = textAttributes(header);
    image.channels.reserve(count);
    Imf::FrameBuffer buffer;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        image.channels.push_back(
            {it.name(), std::vector<float>(static_cast<std::size_t>(width * height))});
        buffer.insert(it.name(),
                      Imf::Slice::Make(Imf::FLOAT, image.channels.back().values.data(), window));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

} // namespace decoder
