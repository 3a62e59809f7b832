// SPDX-License-Identifier: MIT
#include <grader/digest.h>
#include <grader/error.h>

#include <openssl/evp.h>

#include <array>

namespace grader {

std::string sha256Hex(std::string_view bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
        throw GraderError("sha256Hex: OpenSSL failed; is SHA-256 disabled on this machine?");
    }
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string hex;
    for (unsigned int i = 0; i < size; ++i) {
        hex += kDigits[digest[i] >> 4U];
        hex += kDigits[digest[i] & 0xFU];
    }
    return hex;
}

} // namespace grader
