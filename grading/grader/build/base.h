// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace grader {

/// File name to text. Headers are named as they are included (`nori/mesh.h`, `pcg32.h`), sources by
/// their plain name (`mesh.cpp`).
using Files = std::map<std::string, std::string>;

/// The code that a submission is laid over.
struct Base {
    Files
        headers; ///< of the renderer, of what it brings for submissions, of the probe and protocol
    Files units; ///< renderer sources
};

/// The student edition: graded bodies throw, reference-only members are gone.
const Base &starterBase();

/// Our complete renderer. Only single units of it enter a box, upstream of what is judged.
const Base &referenceBase();

/// SHA-256 of all names and texts.
std::string digestOf(const Base &base);

/// The probe's and protocol's sources, by their path below grading/ (`probe/main.cpp`).
const Files &probeUnits();

/// Sources of the base that register a scene `type`: the link can do without one of them.
bool isPlugin(const std::string &unit);

/// Root of the project, where renderer/, grading/ and scenes/ stand.
/// \throws GraderError  if it has been moved or removed since the build
std::filesystem::path projectFolder();

} // namespace grader
