// SPDX-License-Identifier: MIT
#include "patch.h"

#include <grader/text_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "toml_file.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

Patch::Cost costOf(const TomlFile &file, const toml::node &node) {
    const std::string text = file.text(node);
    if (text == "visible")
        return Patch::Cost::Visible;
    if (text == "latent")
        return Patch::Cost::Latent;
    if (text == "blemish")
        return Patch::Cost::Blemish;
    file.fail(node, R"(expected "visible", "latent" or "blemish")");
}

std::vector<Change> changesOf(const TomlFile &file, const toml::node &node, bool whole) {
    std::vector<Change> changes;
    for (const toml::table *table : file.tables(node)) {
        Change change;
        for (const auto &[key, value] : *table) {
            if (key.str() == "file")
                change.file = file.text(value);
            else if (key.str() == "old" && !whole)
                change.before = file.text(value);
            else if (key.str() == (whole ? "text" : "new"))
                change.after = file.text(value);
            else
                file.fail(value, fmt::format("unknown key {}", key.str()));
        }
        if (change.file.empty() || change.before.empty() != whole)
            file.fail(*table, whole ? "needed: file, text" : "needed: file, old, new");
        if (!whole && change.before == change.after)
            file.fail(*table, "old and new are the same: nothing would change");
        changes.push_back(std::move(change));
    }
    return changes;
}

Patch readPatch(const fs::path &path, const std::string &name) {
    const TomlFile file(path);
    Patch patch;
    patch.name = name;
    for (const auto &[key, node] : file.root()) {
        if (key.str() == "base")
            patch.base = file.text(node);
        else if (key.str() == "what")
            patch.what = file.text(node);
        else if (key.str() == "item")
            patch.item = file.text(node);
        else if (key.str() == "cost")
            patch.cost = costOf(file, node);
        else if (key.str() == "diagnosis")
            patch.diagnoses =
                node.is_array() ? file.texts(node) : std::vector<std::string>{file.text(node)};
        else if (key.str() == "equivalent")
            patch.equivalent = file.text(node);
        else if (key.str() == "missing")
            patch.missing = file.texts(node);
        else if (key.str() == "without")
            patch.without = file.texts(node);
        else if (key.str() == "change")
            patch.changes = changesOf(file, node, false);
        else if (key.str() == "file")
            patch.files = changesOf(file, node, true);
        else if (key.str() == "crlf")
            patch.crlf = file.flag(node);
        else
            file.fail(node, fmt::format("unknown key {}", key.str()));
    }
    if (patch.base.empty() || patch.what.empty())
        file.fail(file.root(), "needed: base, what");
    if (patch.item.empty() != (patch.cost == Patch::Cost::Nothing))
        file.fail(file.root(), "item and cost belong together");
    return patch;
}

void replaceOnce(const Patch &patch, const Change &change, const fs::path &folder) {
    const fs::path file = folder / change.file;
    if (!fs::exists(file))
        throw ExamError(fmt::format("{}: {} has no {}", patch.name, patch.base, change.file));
    std::string text = grader::readTextFile(file);
    const std::size_t at = text.find(change.before);
    if (at == std::string::npos || text.find(change.before, at + 1) != std::string::npos)
        throw ExamError(fmt::format("{}: the text to change is {} in {}'s {}:\n{}", patch.name,
                                    at == std::string::npos ? "not" : "more than once", patch.base,
                                    change.file, change.before));
    text.replace(at, change.before.size(), change.after);
    std::ofstream(file, std::ios::binary) << text;
}

void endLinesAsWindowsDoes(const fs::path &folder) {
    for (const auto &entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file())
            continue;
        std::string text;
        for (const char c : grader::readTextFile(entry.path()))
            text += c == '\n' ? std::string("\r\n") : std::string(1, c);
        std::ofstream(entry.path(), std::ios::binary) << text;
    }
}

} // namespace

const char *Patch::costName() const {
    switch (cost) {
    case Cost::Nothing:
        return "nothing";
    case Cost::Visible:
        return "visible";
    case Cost::Latent:
        return "latent";
    case Cost::Blemish:
        return "blemish";
    }
    return "?";
}

std::vector<Patch> findPatches(const fs::path &folder, const std::string &pattern) {
    std::vector<Patch> patches;
    for (const auto &entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".toml")
            continue;
        const std::string name =
            entry.path().lexically_relative(folder).replace_extension().string();
        if (name.find(pattern) != std::string::npos)
            patches.push_back(readPatch(entry.path(), name));
    }
    if (patches.empty())
        throw ExamError(
            fmt::format("{}: nothing has \"{}\" in its name", folder.string(), pattern));
    std::sort(patches.begin(), patches.end(),
              [](const Patch &a, const Patch &b) { return a.name < b.name; });
    return patches;
}

fs::path apply(const Patch &patch, const fs::path &submissions, const fs::path &work) {
    const fs::path base = submissions / patch.base;
    if (!fs::exists(base / "expected.toml"))
        throw ExamError(fmt::format("{}: there is no base {}", patch.name, patch.base));
    const fs::path folder = work / fs::path(patch.name).filename();
    fs::create_directories(folder);
    fs::copy(base, folder, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    fs::remove(folder / "expected.toml");
    for (const std::string &file : patch.without) {
        if (!fs::remove(folder / file))
            throw ExamError(fmt::format("{}: {} has no {}", patch.name, patch.base, file));
    }
    for (const Change &file : patch.files) {
        fs::create_directories((folder / file.file).parent_path());
        std::ofstream(folder / file.file, std::ios::binary) << file.after;
    }
    for (const Change &change : patch.changes)
        replaceOnce(patch, change, folder);
    if (patch.crlf)
        endLinesAsWindowsDoes(folder);
    return folder;
}

} // namespace exam
