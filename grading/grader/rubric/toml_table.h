// SPDX-License-Identifier: MIT
#pragma once

#include <grader/toml_text.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// Reads one TOML table strictly: every key has to be asked for, of the right type and in range.
/// Each function throws GraderError with file:line:column.
class TomlTable {
public:
    /// The document. \param file  for messages
    TomlTable(const toml::table &table, std::string file)
        : TomlTable(table, std::move(file), "", "rubric") {}

    std::optional<std::string> findText(std::string_view key);
    std::optional<double> findNumber(std::string_view key, double least, double most);
    std::optional<bool> findFlag(std::string_view key);

    /// One of `known`, as its position.
    std::optional<std::size_t> findChoice(std::string_view key,
                                          const std::vector<std::string> &known);

    std::string text(std::string_view key);
    double number(std::string_view key, double least, double most);

    /// A name for use in reports and on command lines: lower case letters, digits, `.`, `_`, `-`.
    std::string identifier(std::string_view key);

    /// A sub-table.
    TomlTable table(std::string_view key);

    /// The elements of an array of tables, none if the key is absent.
    std::vector<TomlTable> tables(std::string_view key);

    /// To be called when everything was asked for: refuses what is left over.
    void rejectUnknownKeys() const;

    /// `file:line:column` of a key's value, or of the table.
    std::string where(std::string_view key = {}) const;

    [[noreturn]] void fail(std::string_view key, const std::string &what) const;

private:
    TomlTable(const toml::table &table, std::string file, std::string path, std::string name)
        : m_table(table),
          m_file(std::move(file)),
          m_path(std::move(path)),
          m_name(std::move(name)) {}

    const toml::node *find(std::string_view key);

    const toml::table &m_table;
    std::string m_file;
    std::string m_path; ///< `item.check`; empty for the document
    std::string m_name; ///< for messages: `[assignment]`
    std::vector<std::string> m_known;
};

} // namespace grader
