// SPDX-License-Identifier: MIT
#include <nori/scene_text.h>

#include <iconv.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

NORI_NAMESPACE_BEGIN

namespace {

bool startsWith(const std::string &text, const char *start) {
    return text.compare(0, std::strlen(start), start) == 0;
}

/// What the mark at the file's begin or its XML declaration says; empty: nothing, so UTF-8.
std::string encodingOf(const std::string &bytes) {
    if (startsWith(bytes, "\xff\xfe") || startsWith(bytes, "\xfe\xff"))
        return "UTF-16";
    if (!startsWith(bytes, "<?xml"))
        return "";
    const std::string key = "encoding=";
    const std::string declaration = bytes.substr(0, bytes.find("?>"));
    const size_t at = declaration.find(key);
    if (at == std::string::npos || at + key.size() >= declaration.size())
        return "";
    const size_t begin = at + key.size() + 1; // behind the quote
    return declaration.substr(begin, declaration.find(declaration[begin - 1], begin) - begin);
}

/// \throws NoriException
std::string toUtf8(std::string bytes, const std::string &encoding, const std::string &fileName) {
    iconv_t converter = iconv_open("UTF-8", encoding.c_str());
    if (converter == reinterpret_cast<iconv_t>(-1)) // NOLINT: how iconv says it
        throw NoriException("%s: the encoding \"%s\" is unknown; known is UTF-8", fileName,
                            encoding);
    std::string result(4 * bytes.size(), '\0'); // the longest that a character of UTF-8 is
    char *in = bytes.data();
    char *out = result.data();
    size_t inLeft = bytes.size();
    size_t outLeft = result.size();
    const bool good = iconv(converter, &in, &inLeft, &out, &outLeft) != static_cast<size_t>(-1);
    iconv_close(converter);
    if (!good)
        throw NoriException("%s: is not written in %s, as it says", fileName, encoding);
    result.resize(result.size() - outLeft);
    return result;
}

} // namespace

SceneText::SceneText(const std::string &fileName) : m_name(fileName) {
    struct stat status {};

    if (stat(fileName.c_str(), &status) != 0)
        throw NoriException("%s: %s", fileName, std::strerror(errno));
    if (!S_ISREG(status.st_mode))
        throw NoriException("%s: is no file", fileName);
    std::ifstream stream(fileName, std::ios::binary);
    m_bytes.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    if (!stream)
        throw NoriException("%s: cannot be read", fileName);
    const std::string encoding = encodingOf(m_bytes);
    if (!encoding.empty() && toLower(encoding) != "utf-8")
        m_bytes = toUtf8(std::move(m_bytes), encoding, fileName);
    const char *const mark = "\xef\xbb\xbf"; // Notepad's, of UTF-8
    if (startsWith(m_bytes, mark))
        m_bytes.erase(0, std::strlen(mark));
}

std::string SceneText::place(std::ptrdiff_t offset) const {
    if (offset < 0 || m_bytes.empty())
        return m_name;
    const auto end = std::min(static_cast<size_t>(offset), m_bytes.size());
    const auto line =
        1 + std::count(m_bytes.begin(), m_bytes.begin() + static_cast<long>(end), '\n');
    return m_name + ":" + std::to_string(line);
}

std::string joinNames(const std::vector<std::string> &names) {
    std::string text;
    for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

NORI_NAMESPACE_END
