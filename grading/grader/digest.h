// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace grader {

/// SHA-256 of `bytes`, 64 hexadecimal digits.
/// \throws GraderError  if the crypto library cannot be used.
std::string sha256Hex(std::string_view bytes);

} // namespace grader
