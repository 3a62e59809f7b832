// SPDX-License-Identifier: MIT
#include "hand_in.h"

#include <grader/text_file.h>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

constexpr const char *kExpectation = "expected.toml";

/// Files below `folder`, sorted, so that every run packs the same bytes in the same order.
std::vector<fs::path> filesBelow(const fs::path &folder) {
    std::vector<fs::path> files;
    for (const auto &entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file())
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void copyOver(const fs::path &from, const fs::path &to) {
    for (const fs::path &file : filesBelow(from)) {
        if (file.filename() == kExpectation)
            continue;
        const fs::path target = to / file.lexically_relative(from);
        fs::create_directories(target.parent_path());
        fs::copy_file(file, target, fs::copy_options::overwrite_existing);
    }
}

void pack(const fs::path &folder, const fs::path &zip) {
    const std::unique_ptr<archive, decltype(&archive_write_free)> writer(archive_write_new(),
                                                                         archive_write_free);
    const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(),
                                                                              archive_entry_free);
    const auto check = [&](la_ssize_t result) {
        if (result < ARCHIVE_OK)
            throw ExamError(
                fmt::format("{}: {}", zip.string(), archive_error_string(writer.get())));
    };
    check(archive_write_set_format_zip(writer.get()));
    check(archive_write_open_filename(writer.get(), zip.c_str()));
    for (const fs::path &file : filesBelow(folder)) {
        const std::string bytes = grader::readTextFile(file);
        archive_entry_clear(entry.get());
        archive_entry_set_pathname(entry.get(), file.lexically_relative(folder).c_str());
        archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), 0644);
        check(archive_write_header(writer.get(), entry.get()));
        check(archive_write_data(writer.get(), bytes.data(), bytes.size()));
    }
    check(archive_write_close(writer.get()));
}

} // namespace

std::vector<Case> findCases(const fs::path &root, const std::string &pattern) {
    std::vector<Case> cases;
    for (const fs::path &file : filesBelow(root)) {
        const std::string name = file.parent_path().lexically_relative(root).string();
        if (file.filename() == kExpectation && name.find(pattern) != std::string::npos)
            cases.push_back({name, readExpectation(file)});
    }
    if (cases.empty())
        throw ExamError(
            fmt::format("{}: no hand-in has \"{}\" in its name", root.string(), pattern));
    return cases;
}

fs::path compose(const fs::path &root, const Case &which, const fs::path &norigrade,
                 const fs::path &work) {
    const Recipe &recipe = which.expectation.recipe;
    fs::path folder = work / fs::path(which.name).filename();
    if (recipe.fromStarter) {
        const Outcome outcome = runCommand({norigrade.string(), "starter", folder.string()}, work);
        if (outcome.exitCode != 0)
            throw ExamError(fmt::format("{}: norigrade starter: {}", which.name, outcome.errors));
    }
    fs::create_directories(folder);
    if (!recipe.base.empty()) {
        if (!fs::exists(root / recipe.base / kExpectation))
            throw ExamError(fmt::format("{}: there is no base {}", which.name, recipe.base));
        copyOver(root / recipe.base, folder);
    }
    for (const std::string &path : recipe.without) {
        if (!fs::remove(folder / path))
            throw ExamError(fmt::format("{}: {} has no {}", which.name, recipe.base, path));
    }
    copyOver(root / which.name, folder);
    if (recipe.zip.empty())
        return folder;
    fs::path zip = work / recipe.zip;
    pack(folder, zip);
    return zip;
}

} // namespace exam
