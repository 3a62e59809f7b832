// SPDX-License-Identifier: MIT
#include "expectation.h"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <utility>

#include "toml_file.h"

namespace exam {

namespace {

/// The values of an expected.toml.
class Reader {
public:
    explicit Reader(const TomlFile &file) : m_file(file) {}

    std::string text(const toml::node &node) const { return m_file.text(node); }

    bool flag(const toml::node &node) const { return m_file.flag(node); }

    std::vector<std::string> texts(const toml::node &node) const { return m_file.texts(node); }

    /// `100` or `{ min = 0, max = 70 }`.
    void total(const toml::node &node, Expectation &expectation) const {
        const toml::table *range = node.as_table();
        if (range == nullptr) {
            expectation.minTotal = expectation.maxTotal = m_file.number(node);
            return;
        }
        for (const auto &[key, bound] : *range) {
            if (key.str() == "min")
                expectation.minTotal = m_file.number(bound);
            else if (key.str() == "max")
                expectation.maxTotal = m_file.number(bound);
            else
                m_file.fail(bound, "known here: min, max");
        }
    }

    /// `["warp.disk"]`, or "all" or "others" for the items that are named nowhere else.
    void items(const toml::node &node, Kept kept, Expectation &expectation) const {
        if (!node.is_array()) {
            const std::string rest = text(node);
            if (rest != "all" && rest != "others")
                m_file.fail(node, R"(expected a list of items, "all" or "others")");
            expectation.others = kept;
            return;
        }
        for (const std::string &item : texts(node))
            expectation.items[item] = kept;
    }

    /// A table of `name = verdict`.
    void verdicts(const toml::node &node, std::map<std::string, std::string> &to) const {
        for (const auto &[name, verdict] : m_file.table(node))
            to[std::string(name.str())] = text(verdict);
    }

private:
    const TomlFile &m_file;
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
             reader.verdicts(node, to.verdicts);
         }},
        {"figures",
         [](const Reader &reader, const toml::node &node, Expectation &to) {
             reader.verdicts(node, to.figures);
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

} // namespace

Expectation readExpectation(const std::filesystem::path &file) {
    const TomlFile toml(file);
    const Reader reader(toml);
    Expectation expectation;
    for (const auto &[key, node] : toml.root()) {
        const auto setter = setters().find(std::string(key.str()));
        if (setter == setters().end())
            toml.fail(node, fmt::format("unknown key {}", key.str()));
        setter->second(reader, node, expectation);
    }
    return expectation;
}

} // namespace exam
