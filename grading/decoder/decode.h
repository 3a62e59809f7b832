// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/image.h>

#include <stdexcept>

/// Makes planes of numbers of image files. Runs in the box; judges nothing.
namespace decoder {

/// Why a file is no image for us.
class DecodeError : public std::runtime_error {
public:
    DecodeError(protocol::ImageFault fault, const std::string &message)
        : std::runtime_error(message), m_fault(fault) {}

    protocol::ImageFault fault() const { return m_fault; }

private:
    protocol::ImageFault m_fault;
};

/// Decodes a file by what it holds, whatever its name is.
protocol::ImageAnswer decode(const char *data, std::size_t size);

/// First part of an OpenEXR file: every channel in 32-bit floats; the attributes that are text or
/// a number. Pixels are those of the data window.
/// \throws DecodeError, std::exception of the library (Broken)
protocol::Image decodeExr(const char *data, std::size_t size);

/// Channels R, G, B in linear light [0, 1], A where there is one, from 8 bits each; grey images
/// have R = G = B. \throws DecodeError
protocol::Image decodePng(const char *data, std::size_t size);

/// \throws DecodeError  if that is more than we decode, or nothing
void requireSize(std::int64_t width, std::int64_t height, std::size_t channels);

} // namespace decoder
