// SPDX-License-Identifier: MIT
#include "result_cache.h"

#include <grader/digest.h>
#include <grader/text_file.h>

#include <fmt/format.h>

#include <algorithm>

namespace exam {

namespace {

namespace fs = std::filesystem;

/// Digest of a file, or of all files below a folder with their names.
std::string digestOf(const fs::path &path) {
    if (!fs::is_directory(path))
        return grader::sha256Hex(grader::readTextFile(path));
    std::vector<fs::path> files;
    for (const auto &entry : fs::recursive_directory_iterator(path)) {
        if (entry.is_regular_file())
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::string all;
    for (const fs::path &file : files)
        all += fmt::format("{} {}\n", file.lexically_relative(path).string(),
                           grader::sha256Hex(grader::readTextFile(file)));
    return grader::sha256Hex(all);
}

} // namespace

ResultCache::ResultCache(fs::path folder, const std::vector<fs::path> &dependsOn)
    : m_folder(std::move(folder)) {
    fs::create_directories(m_folder);
    std::string all;
    for (const fs::path &path : dependsOn)
        all += digestOf(path) + "\n";
    m_digest = grader::sha256Hex(all);
}

std::string ResultCache::key(const fs::path &handIn, const std::string &question) const {
    return grader::sha256Hex(fmt::format("{}\n{}\n{}", m_digest, digestOf(handIn), question));
}

std::optional<std::string> ResultCache::find(const std::string &key) const {
    const fs::path file = m_folder / (key + ".json");
    if (!fs::exists(file))
        return std::nullopt;
    return grader::readTextFile(file);
}

void ResultCache::store(const std::string &key, const std::string &result) const {
    grader::writeTextFile(m_folder / (key + ".json"), result);
}

} // namespace exam
