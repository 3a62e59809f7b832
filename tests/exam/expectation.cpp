// SPDX-License-Identifier: MIT
#include "expectation.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <functional>
#include <utility>

namespace exam {

namespace {

[[noreturn]] void fail(const std::filesystem::path &file, const toml::node &node,
                       const std::string &what) {
    throw ExamError(fmt::format("{}:{}: {}", file.string(), node.source().begin.line, what));
}

class Reader {
public:
    explicit Reader(std::filesystem::path file) : m_file(std::move(file)) {}

    std::string text(const toml::node &node) const {
        const auto value = node.value_exact<std::string>();
        if (!value)
            fail(m_file, node, "expected a string");
        return *value;
    }

    double number(const toml::node &node) const {
        const auto value = node.value<double>();
        if (!value)
            fail(m_file, node, "expected a number");
        return *value;
    }

    bool flag(const toml::node &node) const {
        const auto value = node.value_exact<bool>();
        if (!value)
            fail(m_file, node, "expected true or false");
        return *value;
    }

    std::vector<std::string> texts(const toml::node &node) const {
        const toml::array *array = node.as_array();
        if (array == nullptr)
            fail(m_file, node, "expected a list of strings");
        std::vector<std::string> result;
        for (const toml::node &each : *array)
            result.push_back(text(each));
        return result;
    }

    /// `100` or `{ min = 0, max = 70 }`.
    void total(const toml::node &node, Expectation &expectation) const {
        const toml::table *range = node.as_table();
        if (range == nullptr) {
            expectation.minTotal = expectation.maxTotal = number(node);
            return;
        }
        for (const auto &[key, bound] : *range) {
            if (key.str() == "min")
                expectation.minTotal = number(bound);
            else if (key.str() == "max")
                expectation.maxTotal = number(bound);
            else
                fail(m_file, bound, "known here: min, max");
        }
    }

    /// `["warp.disk"]`, or "all" or "others" for the items that are named nowhere else.
    void items(const toml::node &node, Kept kept, Expectation &expectation) const {
        if (!node.is_array()) {
            const std::string rest = text(node);
            if (rest != "all" && rest != "others")
                fail(m_file, node, R"(expected a list of items, "all" or "others")");
            expectation.others = kept;
            return;
        }
        for (const std::string &item : texts(node))
            expectation.items[item] = kept;
    }

    void verdicts(const toml::node &node, Expectation &expectation) const {
        const toml::table *table = node.as_table();
        if (table == nullptr)
            fail(m_file, node, "expected a table of item = verdict");
        for (const auto &[item, verdict] : *table)
            expectation.verdicts[std::string(item.str())] = text(verdict);
    }

private:
    std::filesystem::path m_file;
};

using Setter = std::function<void(const Reader &, const toml::node &, Expectation &)>;

Setter keptSetter(Kept kept) {
    return [kept](const Reader &reader, const toml::node &node, Expectation &to) {
        reader.items(node, kept, to);
    };
}

const std::map<std::string, Setter> &setters() {
    static const std::map<std::string, Setter> table = {
        {"base",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             to.recipe.base = reader.text(node);
         }},
        {"without",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             to.recipe.without = reader.texts(node);
         }},
        {"zip",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             to.recipe.zip = reader.text(node);
         }},
        {"from_starter",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             to.recipe.fromStarter = reader.flag(node);
         }},
        {"total",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             reader.total(node, to);
         }},
        {"full", keptSetter(Kept::Full)},
        {"lost", keptSetter(Kept::Lost)},
        {"zero", keptSetter(Kept::Zero)},
        {"verdicts",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             reader.verdicts(node, to);
         }},
        {"diagnosis",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             to.diagnosis = reader.text(node);
         }},
        {"hostile",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             to.hostile = reader.flag(node);
         }},
        {"tries_to_leave",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             to.leftFiles = reader.texts(node);
         }},
    };
    return table;
}

toml::table parse(const std::filesystem::path &file) {
    try {
        return toml::parse_file(file.string());
    } catch (const toml::parse_error &error) {
        throw ExamError(fmt::format("{}:{}: {}", file.string(), error.source().begin.line,
                                    error.description()));
    }
}

} // namespace

Expectation readExpectation(const std::filesystem::path &file) {
    const toml::table table = parse(file);
    const Reader reader(file);
    Expectation expectation;
    for (const auto &[key, node] : table) {
        const auto setter = setters().find(std::string(key.str()));
        if (setter == setters().end())
            fail(file, node, fmt::format("unknown key {}", key.str()));
        setter->second(reader, node, expectation);
    }
    return expectation;
}

} // namespace exam
