// SPDX-License-Identifier: MIT
#include <grader/submission/names.h>
#include <grader/submission/text.h>

#include <algorithm>

namespace grader {

namespace {

bool startsWith(std::string_view text, std::string_view prefix) {
    return text.substr(0, prefix.size()) == prefix;
}

/// The ICU name of the UTF-16 that `bytes` are in, or null. Without a mark: mostly ASCII, so that
/// every second byte is zero.
const char *findUtf16(std::string_view bytes) {
    if (startsWith(bytes, "\xFF\xFE")) {
        return "UTF-16LE";
    }
    if (startsWith(bytes, "\xFE\xFF")) {
        return "UTF-16BE";
    }
    if (bytes.empty() || bytes.size() % 2 != 0) {
        return nullptr;
    }
    std::size_t zerosAtEven = 0;
    std::size_t zerosAtOdd = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        zerosAtEven += bytes[i] == '\0' ? 1U : 0U;
        zerosAtOdd += bytes[i + 1] == '\0' ? 1U : 0U;
    }
    const std::size_t most = bytes.size() / 2 - bytes.size() / 20; // 9 of 10 characters
    if (zerosAtEven == 0 && zerosAtOdd >= most) {
        return "UTF-16LE";
    }
    return zerosAtOdd == 0 && zerosAtEven >= most ? "UTF-16BE" : nullptr;
}

} // namespace

NormalizedText normalizeText(std::string_view bytes) {
    NormalizedText result;
    std::string converted;
    if (const char *charset = findUtf16(bytes); charset != nullptr) {
        converted = toUtf8(bytes, charset);
        bytes = converted;
        result.wasUtf16 = true;
    }
    if (startsWith(bytes, "\xEF\xBB\xBF")) {
        bytes.remove_prefix(3);
    }
    result.text.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (bytes[i] != '\r') {
            result.text += bytes[i];
        } else if (i + 1 == bytes.size() || bytes[i + 1] != '\n') {
            result.text += '\n';
        }
    }
    result.hasNul = result.text.find('\0') != std::string::npos;
    return result;
}

} // namespace grader
