// SPDX-License-Identifier: MIT
#include "header_set.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

namespace grader {

namespace {

/// The spellings between the quotes or brackets of every #include line.
std::vector<std::string> includesOf(const std::string &text) {
    static const std::string kByteOrderMark = "\xEF\xBB\xBF";
    std::vector<std::string> names;
    std::istringstream stream(text);
    if (text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0)
        stream.ignore(static_cast<std::streamsize>(kByteOrderMark.size()));
    for (std::string line; std::getline(stream, line);) {
        std::size_t at = line.find_first_not_of(" \t");
        if (at == std::string::npos || line[at] != '#')
            continue;
        at = line.find_first_not_of(" \t", at + 1);
        if (at == std::string::npos || line.compare(at, 7, "include") != 0)
            continue;
        const std::size_t open = line.find_first_of("<\"", at + 7);
        if (open == std::string::npos)
            continue;
        const std::size_t close = line.find(line[open] == '<' ? '>' : '"', open + 1);
        if (close != std::string::npos)
            names.push_back(line.substr(open + 1, close - open - 1));
    }
    return names;
}

/// What a spelling is on a system that takes upper for lower case and a backslash for a slash; a
/// plain name is looked for in nori/.
std::string asWindowsReadsIt(std::string spelling) {
    std::transform(spelling.begin(), spelling.end(), spelling.begin(), [](unsigned char c) {
        return c == '\\' ? '/' : static_cast<char>(std::tolower(c));
    });
    return spelling.find('/') == std::string::npos ? "nori/" + spelling : spelling;
}

/// Whether the compiler finds it without help.
bool isFound(const std::string &spelling, const HeaderSet &headers) {
    return headers.files.count(spelling) != 0 || headers.files.count("nori/" + spelling) != 0 ||
           headers.forwards.count(spelling) != 0;
}

/// The header that a spelling reaches; empty if it is none of ours.
std::string resolve(const std::string &spelling, const HeaderSet &headers) {
    if (headers.files.count(spelling) != 0)
        return spelling;
    const std::string sibling = "nori/" + spelling.substr(spelling.find_last_of('/') + 1);
    if (headers.files.count(sibling) != 0)
        return sibling;
    const auto forward = headers.forwards.find(spelling);
    return forward != headers.forwards.end() ? forward->second : std::string();
}

} // namespace

HeaderSet overlayHeaders(const Files &base, const Files &submitted) {
    HeaderSet headers{base, {}};
    for (const auto &[name, text] : submitted)
        headers.files["nori/" + name] = text;
    return headers;
}

std::set<std::string> addForwards(const std::string &text, HeaderSet &headers) {
    std::set<std::string> added;
    for (const std::string &spelling : includesOf(text)) {
        const bool escapes =
            spelling.empty() || spelling.front() == '/' || spelling.find("..") != std::string::npos;
        if (escapes || isFound(spelling, headers))
            continue;
        for (const auto &[name, unused] : headers.files) {
            if (name.compare(0, 5, "nori/") == 0 &&
                asWindowsReadsIt(name) == asWindowsReadsIt(spelling)) {
                headers.forwards[spelling] = name;
                added.insert(spelling);
                break;
            }
        }
    }
    return added;
}

std::set<std::string> includeClosure(const std::string &text, const HeaderSet &headers) {
    std::set<std::string> reached;
    std::vector<const std::string *> todo{&text};
    while (!todo.empty()) {
        const std::string &current = *todo.back();
        todo.pop_back();
        for (const std::string &spelling : includesOf(current)) {
            const std::string name = resolve(spelling, headers);
            if (!name.empty() && reached.insert(name).second)
                todo.push_back(&headers.files.at(name));
        }
    }
    return reached;
}

} // namespace grader
