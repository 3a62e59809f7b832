// SPDX-License-Identifier: MIT
#include "toml_table.h"

#include <grader/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nearest_name.h"

namespace grader {

const toml::node *TomlTable::find(std::string_view key) {
    m_known.emplace_back(key);
    return m_table.get(key);
}

std::string TomlTable::where(std::string_view key) const {
    const toml::node *node = key.empty() ? nullptr : m_table.get(key);
    const toml::source_position position = (node != nullptr ? *node : m_table).source().begin;
    return fmt::format("{}:{}:{}", m_file, position.line, position.column);
}

void TomlTable::fail(std::string_view key, const std::string &what) const {
    throw GraderError(fmt::format("{}: {}: {}", where(key), m_name, what));
}

std::optional<std::string> TomlTable::findText(std::string_view key) {
    const toml::node *node = find(key);
    if (node == nullptr)
        return std::nullopt;
    std::optional<std::string> value = node->value_exact<std::string>();
    if (!value)
        fail(key, fmt::format("{} must be a text in quotes", key));
    if (value->empty())
        fail(key, fmt::format("{} is empty", key));
    return value;
}

std::optional<double> TomlTable::findNumber(std::string_view key, double least, double most) {
    const toml::node *node = find(key);
    if (node == nullptr)
        return std::nullopt;
    const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value)
        fail(key, fmt::format("{} must be a number", key));
    if (!(*value >= least && *value <= most))
        fail(key, fmt::format("{} = {} is out of range, must be from {} to {}", key, *value, least,
                              most));
    return value;
}

std::optional<bool> TomlTable::findFlag(std::string_view key) {
    const toml::node *node = find(key);
    if (node == nullptr)
        return std::nullopt;
    const std::optional<bool> value = node->value_exact<bool>();
    if (!value)
        fail(key, fmt::format("{} must be true or false", key));
    return value;
}

std::optional<std::size_t> TomlTable::findChoice(std::string_view key,
                                                 const std::vector<std::string> &known) {
    const std::optional<std::string> value = findText(key);
    if (!value)
        return std::nullopt;
    const auto found = std::find(known.begin(), known.end(), *value);
    if (found == known.end())
        fail(key, fmt::format("{} = \"{}\" is unknown (known: {})", key, *value,
                              fmt::join(known, ", ")));
    return static_cast<std::size_t>(found - known.begin());
}

std::string TomlTable::text(std::string_view key) {
    const std::optional<std::string> value = findText(key);
    if (!value)
        fail("", fmt::format("{} is missing", key));
    return *value;
}

double TomlTable::number(std::string_view key, double least, double most) {
    const std::optional<double> value = findNumber(key, least, most);
    if (!value)
        fail("", fmt::format("{} is missing", key));
    return *value;
}

std::string TomlTable::identifier(std::string_view key) {
    std::string value = text(key);
    const bool plain = std::all_of(value.begin(), value.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
    });
    if (!plain)
        fail(key, fmt::format("{} = \"{}\" may hold only a-z, 0-9, '.', '_' and '-'", key, value));
    return value;
}

TomlTable TomlTable::table(std::string_view key) {
    const toml::node *node = find(key);
    if (node == nullptr)
        fail("", fmt::format("[{}] is missing", key));
    if (!node->is_table())
        fail(key, fmt::format("{} must be a table: [{}]", key, key));
    return {*node->as_table(), m_file, std::string(key), fmt::format("[{}]", key)};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
    std::vector<TomlTable> result;
    const toml::node *node = find(key);
    if (node == nullptr)
        return result;
    if (!node->is_array_of_tables())
        fail(key, fmt::format("{} must be an array of tables: [[{}]]", key, key));
    const std::string path = m_path.empty() ? std::string(key) : fmt::format("{}.{}", m_path, key);
    for (const toml::node &element : *node->as_array())
        result.push_back({*element.as_table(), m_file, path, fmt::format("[[{}]]", path)});
    return result;
}

void TomlTable::rejectUnknownKeys() const {
    for (const auto &[key, value] : m_table) {
        const std::string name(key.str());
        if (std::find(m_known.begin(), m_known.end(), name) != m_known.end())
            continue;
        const toml::source_position position = key.source().begin;
        throw GraderError(fmt::format("{}:{}:{}: {}: unknown key \"{}\"{}", m_file, position.line,
                                      position.column, m_name, name, suggestion(name, m_known)));
    }
}

} // namespace grader
