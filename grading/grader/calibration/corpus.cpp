// SPDX-License-Identifier: MIT
#include "corpus.h"

#include <grader/build/starter.h>
#include <grader/error.h>
#include <grader/text_file.h>
#include <grader/toml_text.h>

#include <fmt/format.h>

#include <algorithm>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr const char *kExpectation = "expected.toml";

toml::table parse(const fs::path &file) {
    return parseToml(readTextFile(file), file.string());
}

std::string textOf(const toml::table &table, const char *key) {
    return table[key].value_or(std::string());
}

std::vector<std::string> textsOf(const toml::table &table, const char *key) {
    std::vector<std::string> texts;
    if (const toml::array *array = table[key].as_array()) {
        for (const toml::node &node : *array)
            texts.push_back(node.value_or(std::string()));
    }
    return texts;
}

template <typename Visit>
void forEachTable(const toml::table &table, const char *key, const Visit &visit) {
    const toml::array *array = table[key].as_array();
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
        if (const toml::table *element = array->get(i)->as_table())
            visit(*element);
    }
}

CorpusCase readCase(const fs::path &file, const fs::path &root) {
    const toml::table table = parse(file);
    const bool isFolder = file.filename() == kExpectation;
    CorpusCase result;
    result.name = (isFolder ? file.parent_path() : fs::path(file).replace_extension())
                      .lexically_relative(root)
                      .string();
    result.what = textOf(table, "what");
    if (isFolder)
        result.own = file.parent_path();
    if (const std::string base = textOf(table, "base"); !base.empty())
        result.base = root / "submissions" / base;
    result.without = textsOf(table, "without");
    result.isStarter = table["from_starter"].value_or(false);
    result.lost = textsOf(table, "lost");
    if (const std::string item = textOf(table, "item"); !item.empty())
        result.lost.push_back(item);
    result.free = textsOf(table, "missing");
    result.windowsLines = table["crlf"].value_or(false);
    forEachTable(table, "change", [&](const toml::table &change) {
        result.changes.push_back(
            {textOf(change, "file"), textOf(change, "old"), textOf(change, "new")});
    });
    forEachTable(table, "file", [&](const toml::table &whole) {
        result.files.emplace_back(textOf(whole, "file"), textOf(whole, "text"));
    });
    return result;
}

bool startsWith(const std::string &text, const char *start) {
    return text.rfind(start, 0) == 0;
}

/// Whether a rubric can be tried on it; see readCorpus().
bool isUsed(const fs::path &file, const fs::path &root) {
    if (file.extension() != ".toml")
        return false;
    const std::string name = file.lexically_relative(root).string();
    if (startsWith(name, "submissions/"))
        return file.filename() == kExpectation &&
               (startsWith(name, "submissions/accepted/") ||
                startsWith(name, "submissions/wrong/") || startsWith(name, "submissions/starter/"));
    if (startsWith(name, "mutants/"))
        return textOf(parse(file), "cost") != "blemish";
    return startsWith(name, "variants/");
}

void copyOver(const fs::path &from, const fs::path &to) {
    for (const auto &entry : fs::recursive_directory_iterator(from)) {
        if (!entry.is_regular_file() || entry.path().filename() == kExpectation)
            continue;
        const fs::path target = to / entry.path().lexically_relative(from);
        fs::create_directories(target.parent_path());
        fs::copy_file(entry.path(), target, fs::copy_options::overwrite_existing);
    }
}

void applyChange(const CorpusCase &which, const TextChange &change, const fs::path &folder) {
    const fs::path file = folder / change.file;
    std::string text = readTextFile(file);
    const std::size_t at = text.find(change.before);
    if (change.before == change.after)
        throw GraderError(fmt::format("{}: a change of {} changes nothing: {}", which.name,
                                      change.file, change.before));
    if (change.before.empty() || at == std::string::npos ||
        text.find(change.before, at + 1) != std::string::npos)
        throw GraderError(fmt::format("{}: a text to change is not in {} exactly once: {}",
                                      which.name, change.file, change.before));
    writeTextFile(file, text.replace(at, change.before.size(), change.after));
}

void writeWindowsLines(const fs::path &folder) {
    for (const auto &entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file())
            continue;
        std::string text;
        for (const char c : readTextFile(entry.path()))
            text += c == '\n' ? std::string("\r\n") : std::string(1, c);
        writeTextFile(entry.path(), text);
    }
}

} // namespace

std::vector<CorpusCase> readCorpus(const fs::path &root, const std::string &only) {
    if (!fs::is_directory(root / "submissions"))
        throw GraderError(fmt::format(
            "{}: there is no folder submissions in it. The corpus is part of the source tree "
            "(tests/), not of an installation: name it with --corpus DIR",
            root.string()));
    std::vector<CorpusCase> cases;
    for (const char *part : {"submissions", "mutants", "variants"}) {
        if (!fs::is_directory(root / part))
            continue;
        for (const auto &entry : fs::recursive_directory_iterator(root / part)) {
            if (entry.is_regular_file() && isUsed(entry.path(), root))
                cases.push_back(readCase(entry.path(), root));
        }
    }
    cases.erase(std::remove_if(cases.begin(), cases.end(),
                               [&](const CorpusCase &each) {
                                   return each.name.find(only) == std::string::npos;
                               }),
                cases.end());
    std::sort(cases.begin(), cases.end(),
              [](const CorpusCase &a, const CorpusCase &b) { return a.name < b.name; });
    if (cases.empty())
        throw GraderError(
            fmt::format("{}: no hand-in has \"{}\" in its name", root.string(), only));
    return cases;
}

void composeCase(const CorpusCase &which, const fs::path &to) {
    if (which.isStarter)
        writeStarter(to);
    if (!which.base.empty() && !fs::is_directory(which.base))
        throw GraderError(fmt::format("{}: there is no base {}", which.name, which.base.string()));
    if (!which.base.empty())
        copyOver(which.base, to);
    for (const std::string &file : which.without) {
        if (!fs::remove(to / file))
            throw GraderError(fmt::format("{}: without {}, which is not there", which.name, file));
    }
    if (!which.own.empty())
        copyOver(which.own, to);
    for (const TextChange &change : which.changes)
        applyChange(which, change, to);
    for (const auto &[name, text] : which.files) {
        fs::create_directories((to / name).parent_path());
        writeTextFile(to / name, text);
    }
    if (which.windowsLines)
        writeWindowsLines(to);
}

} // namespace grader
