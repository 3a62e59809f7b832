// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>

#include <vector>

namespace grader {

// Rows of the check table, one function per file of checks.
std::vector<Check> warpChecks();
std::vector<Check> meshChecks();
std::vector<Check> areaChecks();
std::vector<Check> environmentChecks();
std::vector<Check> sceneChecks();
std::vector<Check> directEmsChecks();
std::vector<Check> repeatChecks();
std::vector<Check> imageChecks();
std::vector<Check> farShadowChecks();
std::vector<Check> relationChecks();
std::vector<Check> noiseChecks();
std::vector<Check> importanceChecks();

/// A small latitude-longitude map of the sky as an EXR file; a name for TestScene::addFile().
std::string skyMap();
constexpr char kSkyMapName[] = "sky.exr";

} // namespace grader
