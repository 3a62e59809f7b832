// SPDX-License-Identifier: MIT
#include "html.h"

#include <grader/error.h>
#include <grader/results/safe_text.h>

#include <openssl/evp.h>

#include <array>

namespace grader {

std::string escapeHtml(std::string_view text) {
    std::string result;
    for (const char c : safeLines(text)) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

std::string contentHash(std::string_view content) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    if (EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr) !=
        1)
        throw GraderError("contentHash: SHA-256 is not available in libcrypto");
    std::array<unsigned char, std::size_t{2} * EVP_MAX_MD_SIZE> text{};
    const int length = EVP_EncodeBlock(text.data(), digest.data(), static_cast<int>(size));
    return "sha256-" + std::string(text.begin(), text.begin() + length);
}

} // namespace grader
