// SPDX-License-Identifier: MIT
#include "base.h"

#include <grader/build/starter.h>
#include <grader/digest.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "base_sources.h"

namespace grader {

namespace {

std::vector<std::string> split(const std::string &list) {
    std::vector<std::string> names;
    std::istringstream stream(list);
    for (std::string name; std::getline(stream, name, ';');)
        names.push_back(name);
    return names;
}

void addHeaders(const std::filesystem::path &root, const std::string &below, Files &headers) {
    for (const auto &entry : std::filesystem::recursive_directory_iterator(root / below)) {
        if (entry.path().extension() == ".h")
            headers[entry.path().lexically_relative(root).string()] = readTextFile(entry.path());
    }
}

Base loadReference() {
    const std::filesystem::path root = projectFolder();
    Base base;
    addHeaders(root / "renderer" / "include", "nori", base.headers);
    addHeaders(root / "renderer" / "compat", ".", base.headers);
    addHeaders(root / "grading", "probe", base.headers);
    addHeaders(root / "grading", "protocol", base.headers);
    for (const char *list : {kCoreSources, kPluginSources}) {
        for (const std::string &unit : split(list))
            base.units[unit] = readTextFile(root / "renderer" / "src" / unit);
    }
    return base;
}

Base stripSolutions(const Base &reference) {
    Base base;
    for (const auto &[name, text] : reference.headers) {
        if (auto kept = starterText(text, name))
            base.headers[name] = std::move(*kept);
    }
    for (const auto &[name, text] : reference.units) {
        if (auto kept = starterText(text, name))
            base.units[name] = std::move(*kept);
    }
    return base;
}

} // namespace

std::filesystem::path projectFolder() {
    const std::filesystem::path folder = kProjectFolder;
    if (!std::filesystem::exists(folder / "renderer" / "sources.cmake"))
        throw GraderError(fmt::format("{}: the project that norigrade was built from is not there "
                                      "any more; build it again where it is now",
                                      folder.string()));
    return folder;
}

const Base &referenceBase() {
    static const Base base = loadReference();
    return base;
}

const Base &starterBase() {
    static const Base base = stripSolutions(referenceBase());
    return base;
}

std::string digestOf(const Base &base) {
    std::string all;
    for (const Files *files : {&base.headers, &base.units}) {
        for (const auto &[name, text] : *files)
            all += fmt::format("{} {}\n{}", name, text.size(), text);
    }
    return sha256Hex(all);
}

const Files &probeUnits() {
    static const Files units = [] {
        Files files;
        for (const std::string &unit : split(kProbeSources))
            files[unit] = readTextFile(projectFolder() / "grading" / unit);
        return files;
    }();
    return units;
}

bool isPlugin(const std::string &unit) {
    static const std::vector<std::string> plugins = split(kPluginSources);
    return std::find(plugins.begin(), plugins.end(), unit) != plugins.end();
}

} // namespace grader
