// SPDX-License-Identifier: MIT
#include "frozen_rubric.h"

#include <grader/text_file.h>

#include <fmt/format.h>

#include <map>
#include <sstream>

namespace grader {

namespace {

/// `key value` lines.
std::map<std::string, std::string> readStamp(const std::filesystem::path &file) {
    std::map<std::string, std::string> stamp;
    std::istringstream lines(readTextFile(file));
    std::string key;
    std::string value;
    while (lines >> key && std::getline(lines >> std::ws, value))
        stamp[key] = value;
    return stamp;
}

} // namespace

std::filesystem::path frozenFile(const std::filesystem::path &rubric) {
    std::filesystem::path file = rubric;
    file += ".frozen";
    return file;
}

void freezeRubric(const std::filesystem::path &rubric, const Provenance &provenance,
                  std::size_t handIns, int seeds) {
    writeTextFile(frozenFile(rubric),
                  fmt::format("rubric {}\nbase {}\nnorigrade {}\nhand-ins {}\nseeds {}\n",
                              provenance.rubricDigest, provenance.baseDigest,
                              provenance.toolVersion, handIns, seeds));
}

std::string describeFrozen(const std::filesystem::path &rubric, const Provenance &provenance) {
    const std::filesystem::path file = frozenFile(rubric);
    if (rubric.empty() || !std::filesystem::exists(file))
        return {};
    std::map<std::string, std::string> stamp = readStamp(file);
    if (stamp["rubric"] != provenance.rubricDigest)
        return fmt::format("{} has changed since it was calibrated: run `norigrade calibrate {} "
                           "--freeze` again",
                           rubric.string(), rubric.string());
    if (stamp["base"] != provenance.baseDigest || stamp["norigrade"] != provenance.toolVersion)
        return fmt::format("{} was calibrated with another norigrade or base code",
                           rubric.string());
    return fmt::format("{} is calibrated: tried on {} hand-ins with {} seeds each", rubric.string(),
                       stamp["hand-ins"], stamp["seeds"]);
}

} // namespace grader
