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
    std::vector<std::string> names;
    std::istringstream stream(text);
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

std::string lastComponentLower(const std::string &name) {
    std::string last = name.substr(name.find_last_of("/\\") + 1);
    std::transform(last.begin(), last.end(), last.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return last;
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
        if (escapes || !resolve(spelling, headers).empty())
            continue;
        const bool isOurs = spelling.compare(0, 4, "nori") == 0 ||
                            spelling.find_first_of("/\\") == std::string::npos;
        for (const auto &[name, unused] : headers.files) {
            if (isOurs && name.compare(0, 5, "nori/") == 0 &&
                lastComponentLower(name) == lastComponentLower(spelling)) {
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
