// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace exam {

/// Results of gradings that need not be done again: nothing that they depend on has changed.
class ResultCache {
public:
    /// \param folder     made if it is not there
    /// \param dependsOn  files and folders that every result depends on: the grader, its rubric,
    ///                   and what it reads when it runs
    ResultCache(std::filesystem::path folder, const std::vector<std::filesystem::path> &dependsOn);

    /// Name of a result. \param question  seed and items
    std::string key(const std::filesystem::path &handIn, const std::string &question) const;

    std::optional<std::string> find(const std::string &key) const;

    /// Written at once or not at all.
    void store(const std::string &key, const std::string &result) const;

private:
    std::filesystem::path m_folder;
    std::string m_digest;
};

} // namespace exam
