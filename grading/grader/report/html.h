// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace grader {

/// Text as content or quoted attribute of a page: markup is escaped, invisible controls go.
std::string escapeHtml(std::string_view text);

/// `sha256-...` of a style sheet, for the page's content security policy.
std::string contentHash(std::string_view content);

} // namespace grader
