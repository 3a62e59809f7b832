// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace grader {

/// Why toml++ must not be given this text: TOML has no place for characters beyond ASCII outside of
/// texts and comments, and toml++ 3.3 meets most of them there (a key `latent_fracción`) with
/// undefined behaviour instead of an error.
///
/// \return  `line:column: what and what to do`; empty if nothing is wrong
std::string tomlFault(std::string_view text);

} // namespace grader
