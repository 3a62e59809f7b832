// SPDX-License-Identifier: MIT
#include <protocol/bytes.h>
#include <protocol/image.h>

#include <algorithm>

namespace protocol {

namespace {

constexpr std::uint32_t kMagic = 0x696d6167; // "imag"
constexpr int kLargestSide = 1 << 20;
constexpr std::size_t kSmallestEntry = 8; ///< two empty strings, or a string and no values

} // namespace

const Channel *Image::channel(const std::string &name) const {
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const Channel &channel) { return channel.name == name; });
    return found == channels.end() ? nullptr : &*found;
}

std::string encode(const ImageAnswer &answer) {
    const Image &image = answer.image;
    ByteWriter writer;
    writer.put(kMagic);
    writer.put(answer.fault);
    writer.put(answer.message);
    writer.put(image.format);
    writer.put(image.width);
    writer.put(image.height);
    writer.putSize(image.attributes.size());
    for (const auto &attribute : image.attributes) {
        writer.put(attribute.first);
        writer.put(attribute.second);
    }
    writer.putSize(image.channels.size());
    for (const Channel &channel : image.channels) {
        writer.put(channel.name);
        writer.put(channel.values);
    }
    return writer.take();
}

ImageAnswer decodeImageAnswer(const char *data, std::size_t size) {
    ByteReader reader(data, size);
    if (reader.get<std::uint32_t>() != kMagic)
        throw std::runtime_error("protocol: not an image");
    ImageAnswer answer;
    Image &image = answer.image;
    answer.fault = reader.get<ImageFault>();
    if (answer.fault > ImageFault::TooLarge)
        throw std::runtime_error("protocol: unknown fault of an image");
    answer.message = reader.getString();
    image.format = reader.getString();
    image.width = reader.get<int>();
    image.height = reader.get<int>();
    const bool holds = answer.fault == ImageFault{};
    if (holds && (image.width < 1 || image.height < 1 || image.width > kLargestSide ||
                  image.height > kLargestSide))
        throw std::runtime_error("protocol: no size of an image");
    for (std::size_t left = reader.getCount(kSmallestEntry); left > 0; --left) {
        std::string name = reader.getString();
        image.attributes[std::move(name)] = reader.getString();
    }
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (std::size_t left = reader.getCount(kSmallestEntry); left > 0; --left) {
        Channel channel;
        channel.name = reader.getString();
        channel.values = reader.getFloats();
        if (channel.values.size() != pixels)
            throw std::runtime_error("protocol: a channel of another size than its image");
        if (!image.channels.empty() && image.channels.back().name >= channel.name)
            throw std::runtime_error("protocol: channels out of order");
        image.channels.push_back(std::move(channel));
    }
    if (holds == image.channels.empty())
        throw std::runtime_error("protocol: channels and fault contradict each other");
    reader.requireEnd();
    return answer;
}

} // namespace protocol
