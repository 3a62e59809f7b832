// SPDX-License-Identifier: MIT
#include <grader/submission/base_files.h>
#include <grader/submission/base_names.h>
#include <grader/submission/names.h>

#include <algorithm>
#include <map>

namespace grader {

namespace {

/// Files of the course's base that ours need not have under the same name.
constexpr std::string_view kCourseOnlySources =
    "accel.cpp chi2test.cpp gui.cpp kdtree.cpp main.cpp microfacet.cpp obj.cpp parser.cpp "
    "reflectance.cpp ttest.cpp warptest.cpp";

constexpr std::string_view kCourseOnlyHeaders = "gui.h kdtree.h reflectance.h";

std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        if (end > 0) {
            words.emplace_back(text.substr(0, end));
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

std::map<std::string, BaseName> makeTable() {
    std::map<std::string, BaseName> table;
    const auto add = [&](std::string_view names, bool isHeader, bool isReplaceable) {
        for (const std::string &name : split(names)) {
            // What is there already stays: the replaceable ones come first.
            table.emplace(lowerAscii(name), BaseName{name, isHeader, isReplaceable});
        }
    };
    add(kOverlaySources, false, true);
    add(kBaseSources, false, false);
    add(kCourseOnlySources, false, false);
    add(kOverlayHeaders, true, true);
    add(kBaseHeaders, true, false);
    add(kCourseOnlyHeaders, true, false);
    return table;
}

const std::map<std::string, BaseName> &table() {
    static const std::map<std::string, BaseName> names = makeTable();
    return names;
}

} // namespace

std::optional<BaseName> findBaseName(std::string_view name) {
    const auto found = table().find(lowerAscii(name));
    return found == table().end() ? std::nullopt : std::optional(found->second);
}

const std::vector<std::string> &replaceableSources() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> sorted = split(kOverlaySources);
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    }();
    return names;
}

const std::vector<std::string> &baseStems() {
    static const std::vector<std::string> stems = [] {
        std::vector<std::string> result;
        for (const auto &[lower, base] : table()) {
            if (!base.isHeader) {
                result.push_back(splitPath(lower).stem);
            }
        }
        return result;
    }();
    return stems;
}

} // namespace grader
