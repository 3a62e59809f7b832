// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace fuzz {

/// What an image may claim to hold here [pixels]. Readers allocate what they accept, up to 10^8
/// values, and an execution would be as slow as that; their limits have tests of their own.
constexpr std::int64_t kMostPixels = 1 << 14;

/// The bytes of an OpenEXR file, as the library goes through its headers.
class ExrHeaders {
public:
    explicit ExrHeaders(std::string_view bytes) : m_bytes(bytes) {}

    /// True if one claims more than kMostPixels or kMostPixels chunks, or something as long that is
    /// not there: the library allocates what is claimed, up to 2 GiB, before it reads it, which the
    /// memory limit of the decoder's box holds.
    bool areLarge() {
        const bool hasManyParts = (number() & 0x1000) != 0;
        while (m_at < m_bytes.size()) {
            const std::string_view name = text();
            if (!name.empty()) {
                if (isLargeAttribute(name))
                    return true;
            } else if (!hasManyParts) { // end of a header; of many parts each has its own
                return false;
            }
        }
        return false;
    }

private:
    std::int64_t left() const { return static_cast<std::int64_t>(m_bytes.size() - m_at); }

    void skip(std::int64_t count) { m_at += static_cast<std::size_t>(std::min(count, left())); }

    std::int64_t number() {
        std::int32_t value = 0;
        if (left() >= static_cast<std::int64_t>(sizeof value))
            std::memcpy(&value, m_bytes.data() + m_at, sizeof value);
        skip(sizeof value);
        return std::int64_t{value};
    }

    std::string_view text() {
        const std::string_view found =
            m_bytes.substr(m_at, std::min(m_bytes.find('\0', m_at), m_bytes.size()) - m_at);
        skip(static_cast<std::int64_t>(found.size()) + 1);
        return found;
    }

    static constexpr std::int64_t kUnsigned = 0xffffffff;

    /// Of two sides; 0 where one is below 1, which a reader has to refuse.
    static std::int64_t product(std::int64_t a, std::int64_t b) {
        return std::min(a, b) < 1 ? 0 : std::max(a, b) > kMostPixels ? kMostPixels + 1 : a * b;
    }

    bool isLargeAttribute(std::string_view name) {
        const std::string_view type = text();
        const std::int64_t size = number();
        const std::size_t value = m_at;
        const std::int64_t read = readSize(type, size);
        if (read < 0 || read > std::max(left(), kMostPixels))
            return true;
        const auto at = [&](std::size_t offset) {
            m_at = std::min(value + offset, m_bytes.size());
            return number();
        };
        std::int64_t claimed = 0;
        if (name == "dataWindow")
            claimed = product(at(8) - at(0) + 1, at(12) - at(4) + 1);
        else if (name == "tiles" || type == "preview")
            claimed = product(at(0) & kUnsigned, at(4) & kUnsigned);
        else if (name == "chunkCount")
            claimed = at(0);
        else if (type == "stringvector")
            claimed = longestString(value, size);
        m_at = value;
        skip(read);
        return claimed < 0 || claimed > kMostPixels;
    }

    /// Of strings that each tell their length; -1: one is longer than the file.
    std::int64_t longestString(std::size_t from, std::int64_t size) {
        const std::size_t end = std::min(from + static_cast<std::size_t>(size), m_bytes.size());
        std::int64_t longest = 0;
        for (m_at = from; m_at < end;) {
            const std::int64_t length = number();
            if (length < 0 || length > std::max(left(), kMostPixels))
                return -1;
            longest = std::max(longest, length);
            skip(length);
        }
        return longest;
    }

    /// What the library takes for the value, whatever size is claimed.
    std::int64_t readSize(std::string_view type, std::int64_t size) {
        struct Fixed {
            std::string_view type;
            std::int64_t size;
        };

        constexpr Fixed kFixed[] = {{"box2f", 16},
                                    {"box2i", 16},
                                    {"chromaticities", 32},
                                    {"compression", 1},
                                    {"deepImageState", 1},
                                    {"double", 8},
                                    {"envmap", 1},
                                    {"float", 4},
                                    {"int", 4},
                                    {"keycode", 28},
                                    {"lineOrder", 1},
                                    {"m33d", 72},
                                    {"m33f", 36},
                                    {"m44d", 128},
                                    {"m44f", 64},
                                    {"rational", 8},
                                    {"tiledesc", 9},
                                    {"timecode", 8},
                                    {"v2d", 16},
                                    {"v2f", 8},
                                    {"v2i", 8},
                                    {"v3d", 24},
                                    {"v3f", 12},
                                    {"v3i", 12}};
        for (const Fixed &fixed : kFixed) {
            if (fixed.type == type)
                return fixed.size;
        }
        if (type != "chlist")
            return size;
        const std::size_t begin = m_at;
        while (!text().empty())
            skip(16);
        const auto read = static_cast<std::int64_t>(m_at - begin);
        m_at = begin;
        return read;
    }

    std::string_view m_bytes;
    std::size_t m_at = 4; ///< after the magic number
};

inline bool isLargeExr(std::string_view bytes) {
    return bytes.substr(0, 4) == "\x76\x2f\x31\x01" && ExrHeaders(bytes).areLarge();
}

/// The same for a PNG file, whose chunks libpng allocates as well.
inline bool isLargePng(std::string_view bytes) {
    const auto number = [&](std::size_t at) {
        std::int64_t value = 0;
        for (std::size_t i = at; i < at + 4 && i < bytes.size(); ++i)
            value = value << 8U | static_cast<unsigned char>(bytes[i]);
        return value;
    };
    constexpr std::size_t kChunks = 8; ///< after the magic
    constexpr std::size_t kSides = 16; ///< in the first chunk
    if (bytes.substr(0, kChunks) != "\x89PNG\r\n\x1a\n")
        return false;
    for (std::size_t at = kChunks; at < bytes.size();) {
        const std::int64_t length = number(at);
        if (length > kMostPixels)
            return true;
        at += 12 + static_cast<std::size_t>(length);
    }
    const std::int64_t width = number(kSides);
    const std::int64_t height = number(kSides + 4);
    return width > kMostPixels || height > kMostPixels || width * height > kMostPixels;
}

/// The same for a JPEG file: a marker of a frame, then length, precision, two sides.
inline bool isLargeJpeg(std::string_view bytes) {
    if (bytes.substr(0, 2) != "\xff\xd8")
        return false;
    for (std::size_t i = 0; i + 9 < bytes.size(); ++i) {
        const auto at = [&](std::size_t k) {
            return static_cast<std::int64_t>(static_cast<unsigned char>(bytes[i + k]));
        };
        // 0xc4, 0xc8 and 0xcc are no frames.
        const bool isFrame =
            at(0) == 0xff && at(1) >= 0xc0 && at(1) <= 0xcf && (at(1) == 0xc0 || at(1) % 4 != 0);
        if (isFrame && (at(5) * 256 + at(6)) * (at(7) * 256 + at(8)) > kMostPixels)
            return true;
    }
    return false;
}

inline bool isLargeImage(std::string_view bytes) {
    return isLargeExr(bytes) || isLargePng(bytes) || isLargeJpeg(bytes);
}

} // namespace fuzz
