// SPDX-License-Identifier: MIT
#pragma once

#include <grader/toml_text.h>

#include <filesystem>
#include <string>
#include <vector>

namespace exam {

/// A TOML file whose mistakes are told with file and line: every member throws ExamError.
class TomlFile {
public:
    explicit TomlFile(std::filesystem::path path);

    const toml::table &root() const { return m_root; }

    std::string text(const toml::node &node) const;
    double number(const toml::node &node) const;
    bool flag(const toml::node &node) const;
    std::vector<std::string> texts(const toml::node &node) const;
    const toml::table &table(const toml::node &node) const;
    std::vector<const toml::table *> tables(const toml::node &node) const;

    [[noreturn]] void fail(const toml::node &node, const std::string &what) const;

private:
    std::filesystem::path m_path;
    toml::table m_root;
};

} // namespace exam
