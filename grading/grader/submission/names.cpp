// SPDX-License-Identifier: MIT
#include <grader/submission/names.h>

#include <unicode/normalizer2.h>
#include <unicode/uchar.h>
#include <unicode/unistr.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

namespace grader {

namespace {

constexpr std::size_t kMaxPathBytes = 1024;
constexpr std::size_t kMaxNameBytes = 255;

/// In the order in which a tie is decided: Spanish Windows packs with CP850.
constexpr std::array<const char *, 4> kCharsets{"ibm-850", "ibm-437", "windows-1252", "ISO-8859-1"};

int asLength(std::size_t size) {
    return static_cast<int>(std::min<std::size_t>(size, std::numeric_limits<int>::max()));
}

icu::UnicodeString fromUtf8(std::string_view utf8) {
    return icu::UnicodeString::fromUTF8(icu::StringPiece(utf8.data(), asLength(utf8.size())));
}

std::string normalized(const icu::UnicodeString &text) {
    UErrorCode status = U_ZERO_ERROR;
    const icu::Normalizer2 *nfc = icu::Normalizer2::getNFCInstance(status);
    std::string utf8;
    if (U_SUCCESS(status) != 0) {
        nfc->normalize(text, status).toUTF8String(utf8);
    } else {
        text.toUTF8String(utf8);
    }
    return utf8;
}

/// How much a character beyond ASCII looks like part of a student's file name.
int plausibility(UChar32 before, UChar32 c) {
    static const icu::UnicodeString spanish = icu::UnicodeString::fromUTF8("áéíóúñüçÁÉÍÓÚÑÜÇ");
    if (u_isalpha(c) == 0) {
        return u_iscntrl(c) != 0 || c == 0xFFFD ? -6 : -3; // box drawing, currency, fractions
    }
    if (c > 0x24F) {
        return -1; // Greek letters of CP437
    }
    // A capital within a word in small letters: 'é' of Latin-1 is 'Ú' in CP850.
    const bool capitalInside = u_isupper(c) != 0 && u_islower(before) != 0;
    return (spanish.indexOf(c) >= 0 ? 3 : 1) - (capitalInside ? 4 : 0);
}

int plausibility(const icu::UnicodeString &text) {
    int score = 0;
    UChar32 before = 0;
    for (int i = 0; i < text.length(); i = text.moveIndex32(i, 1)) {
        const UChar32 c = text.char32At(i);
        score += c < 0x80 ? 0 : plausibility(before, c);
        before = c;
    }
    return score;
}

} // namespace

bool isUtf8(std::string_view bytes) {
    const icu::UnicodeString text = fromUtf8(bytes);
    std::string back;
    text.toUTF8String(back); // what is malformed comes back as U+FFFD
    return back == bytes;
}

std::string toUtf8(std::string_view bytes, const char *charset) {
    std::string utf8;
    icu::UnicodeString(bytes.data(), asLength(bytes.size()), charset).toUTF8String(utf8);
    return utf8;
}

std::vector<std::string> decodeNames(const std::vector<std::string> &raw) {
    const char *best = kCharsets.front();
    int bestScore = std::numeric_limits<int>::min();
    for (const char *charset : kCharsets) {
        int score = 0;
        for (const std::string &name : raw) {
            if (!isUtf8(name)) {
                score +=
                    plausibility(icu::UnicodeString(name.data(), asLength(name.size()), charset));
            }
        }
        if (score > bestScore) {
            best = charset;
            bestScore = score;
        }
    }
    std::vector<std::string> names;
    names.reserve(raw.size());
    for (const std::string &name : raw) {
        names.push_back(normalized(
            isUtf8(name) ? fromUtf8(name)
                         : icu::UnicodeString(name.data(), asLength(name.size()), best)));
    }
    return names;
}

std::string foldName(std::string_view utf8) {
    return normalized(fromUtf8(utf8).foldCase());
}

std::string lowerAscii(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return lower;
}

std::string pathFault(std::string_view path) {
    if (path.empty() || path.find('\0') != std::string_view::npos) {
        return "has no usable name";
    }
    if (path.front() == '/' || (path.size() > 1 && path[1] == ':')) {
        return "has an absolute path";
    }
    if (path.size() > kMaxPathBytes) {
        return "has an over-long path";
    }
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string_view part = path.substr(begin, end - begin);
        if (part == "..") {
            return "has a path that leaves the archive";
        }
        if (part.size() > kMaxNameBytes) {
            return "has an over-long name";
        }
        begin = end + 1;
    }
    return "";
}

std::string shortened(std::string_view utf8, std::size_t bytes) {
    if (utf8.size() <= bytes) {
        return std::string(utf8);
    }
    while (bytes > 0 && (static_cast<unsigned char>(utf8[bytes]) & 0xC0U) == 0x80U) {
        --bytes;
    }
    return std::string(utf8.substr(0, bytes)) + "…";
}

PathParts splitPath(std::string_view path) {
    PathParts parts;
    std::size_t begin = 0;
    for (std::size_t end = path.find('/'); end != std::string_view::npos;
         end = path.find('/', begin)) {
        parts.folders.emplace_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    parts.name = path.substr(begin);
    const std::size_t dot = parts.name.rfind('.');
    const bool hasExtension = dot != std::string::npos && dot > 0;
    parts.stem = parts.name.substr(0, hasExtension ? dot : std::string::npos);
    parts.extension = hasExtension ? lowerAscii(parts.name.substr(dot)) : "";
    return parts;
}

} // namespace grader
