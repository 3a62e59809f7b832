// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace fuzz {

/// What an image may claim to hold here [pixels]. Readers allocate what they accept, up to 10^8
/// values, and an execution would be as slow as that; their limits have tests of their own.
constexpr std::int64_t kMostPixels = 1 << 16;

/// True if an OpenEXR file claims more than kMostPixels or kMostPixels chunks, or an attribute that
/// is longer than the file: the library allocates what an attribute claims, up to 2 GiB, before it
/// reads it, which the memory limit of the decoder's box holds.
inline bool isLargeExr(std::string_view bytes) {
    constexpr std::size_t kFirstAttribute = 8; ///< after magic number and version
    const auto number = [&](std::size_t at) {
        std::int32_t value = 0;
        if (at + sizeof value <= bytes.size())
            std::memcpy(&value, bytes.data() + at, sizeof value);
        return std::int64_t{value};
    };
    const bool hasManyParts = (number(4) & 0x1000) != 0;
    for (std::size_t at = kFirstAttribute; at < bytes.size();) {
        const std::string_view name = bytes.substr(at, bytes.find('\0', at) - at);
        if (name.empty()) { // end of a header; of many parts each has its own
            if (!hasManyParts)
                return false;
            ++at;
            continue;
        }
        const std::size_t type = at + name.size() + 1;
        const std::size_t value = bytes.find('\0', std::min(type, bytes.size())) + 5;
        if (value < 5 || value > bytes.size())
            return false; // cut short, or beyond the headers
        const std::int64_t size = number(value - 4);
        if (size < 0 || size > static_cast<std::int64_t>(bytes.size() - value))
            return true;
        std::int64_t claimed = 0;
        if (name == "dataWindow")
            claimed = (number(value + 8) - number(value) + 1) *
                      (number(value + 12) - number(value + 4) + 1);
        else if (name == "tiles")
            claimed = number(value) * number(value + 4);
        else if (name == "chunkCount")
            claimed = number(value);
        if (claimed < 0 || claimed > kMostPixels)
            return true;
        at = value + static_cast<std::size_t>(size);
    }
    return false;
}

/// The same for a PNG file.
inline bool isLargePng(std::string_view bytes) {
    constexpr std::size_t kSize = 16; ///< offset of width and height
    if (bytes.size() < kSize + 8)
        return false;
    std::uint64_t side[2] = {};
    for (std::size_t i = 0; i < 8; ++i)
        side[i / 4] = side[i / 4] << 8U | static_cast<unsigned char>(bytes[kSize + i]);
    return side[0] * side[1] > static_cast<std::uint64_t>(kMostPixels);
}

} // namespace fuzz
