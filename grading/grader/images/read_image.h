// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/box.h>
#include <protocol/image.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace grader {

/// Why a file gave no image: a fact about the file.
struct NoImage {
    std::optional<protocol::ImageFault> fault; ///< none: the decoder did not survive the file
    std::string message;                       ///< what is wrong with the file, without its name
};

using ImageReading = std::variant<protocol::Image, NoImage>;

/// Decodes an OpenEXR or PNG file in a box: image libraries parse what strangers made, and never in
/// this process.
/// \throws GraderError  if we fail, or below sandbox level S2
ImageReading decodeImage(const Sandbox &sandbox, std::string_view bytes);

/// Reads one of the user's own files. Below level S2 it is decoded without a box.
/// \throws GraderError  naming the file and what is wrong with it
protocol::Image readImage(const Sandbox &sandbox, const std::filesystem::path &file);

} // namespace grader
