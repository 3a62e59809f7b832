// SPDX-License-Identifier: MIT
#include "toml_file.h"

#include <grader/error.h>
#include <grader/text_file.h>

#include <fmt/format.h>

#include "expectation.h"

namespace exam {

TomlFile::TomlFile(std::filesystem::path path) : m_path(std::move(path)) {
    try {
        m_root = grader::parseToml(grader::readTextFile(m_path), m_path.string());
    } catch (const grader::GraderError &error) {
        throw ExamError(error.what());
    }
}

void TomlFile::fail(const toml::node &node, const std::string &what) const {
    throw ExamError(fmt::format("{}:{}: {}", m_path.string(), node.source().begin.line, what));
}

std::string TomlFile::text(const toml::node &node) const {
    const auto value = node.value_exact<std::string>();
    if (!value)
        fail(node, "expected a string");
    return *value;
}

double TomlFile::number(const toml::node &node) const {
    const auto value = node.value<double>();
    if (!value)
        fail(node, "expected a number");
    return *value;
}

bool TomlFile::flag(const toml::node &node) const {
    const auto value = node.value_exact<bool>();
    if (!value)
        fail(node, "expected true or false");
    return *value;
}

std::vector<std::string> TomlFile::texts(const toml::node &node) const {
    const toml::array *array = node.as_array();
    if (array == nullptr)
        fail(node, "expected a list of strings");
    std::vector<std::string> result;
    for (const toml::node &each : *array)
        result.push_back(text(each));
    return result;
}

const toml::table &TomlFile::table(const toml::node &node) const {
    const toml::table *table = node.as_table();
    if (table == nullptr)
        fail(node, "expected a table");
    return *table;
}

std::vector<const toml::table *> TomlFile::tables(const toml::node &node) const {
    const toml::array *array = node.as_array();
    if (array == nullptr)
        fail(node, "expected [[tables]]");
    std::vector<const toml::table *> result;
    for (const toml::node &each : *array)
        result.push_back(&table(each));
    return result;
}

} // namespace exam
