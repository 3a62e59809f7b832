// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>
#include <grader/sandbox/box.h>

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// How much one check counts within its item.
struct RubricCheck {
    std::string id;
    Severity severity = Severity::Visible;
    double weight = 1;
    double tolerance = 0; ///< effect up to which nothing is lost
    double gross = 0;     ///< effect from which all is lost; log-linear in between
};

struct RubricItem {
    std::string id;
    double points = 0;
    bool extra = false;
    std::string title;
    double latentFraction = 0.25; ///< most that latent defects may cost of this item
    std::vector<RubricCheck> checks;
};

enum class ExtrasPolicy { FillToCap, OverCap, Ignore };

/// A rubric as read from TOML.
struct Rubric {
    std::string id;
    std::string title;
    double cap = 100;
    ExtrasPolicy extras = ExtrasPolicy::FillToCap;
    SandboxLevel minSandbox = SandboxLevel::S2;
    std::vector<RubricItem> items;
    std::string digest; ///< SHA-256 of the file
};

/// \throws GraderError  with file:line:column and the nearest known key, on anything unknown,
///                      missing, repeated or out of range
Rubric readRubric(const std::filesystem::path &file);

} // namespace grader
