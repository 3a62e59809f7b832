// SPDX-License-Identifier: MIT
#include "engine_digest.h"

#include <grader/build/base.h>
#include <grader/build/compiler.h>
#include <grader/digest.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <filesystem>

namespace grader {

namespace {

Files filesBelow(const std::filesystem::path &folder) {
    Files files;
    std::error_code error;
    const std::filesystem::recursive_directory_iterator entries(folder, error);
    if (error)
        throw GraderError(folder.string() + ": " + error.message());
    for (const auto &entry : entries) {
        if (entry.is_regular_file())
            files[entry.path().lexically_relative(folder).string()] = readTextFile(entry.path());
    }
    return files;
}

} // namespace

std::string engineDigest(SandboxLevel level) {
    const std::filesystem::path scenes = projectFolder() / "scenes";
    std::string all = toolchainIdentity() + sandboxLevelName(level);
    for (const char *program : {"/proc/self/exe", NORI_REFERENCE_PROBE})
        all += sha256Hex(readTextFile(program));
    for (const Base &base : {starterBase(), referenceBase(), Base{{}, probeUnits()},
                             Base{{}, filesBelow(scenes / "grading")},
                             Base{{}, filesBelow(scenes / "assignment-2" / "serapis")}})
        all += digestOf(base);
    return sha256Hex(all);
}

} // namespace grader
