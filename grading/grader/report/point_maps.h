// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>

#include <string>

namespace grader {

/// For each check that kept a map of points: where they fall, where they should, and the
/// difference, as figures of a page (mapFigures()). Empty if there is none.
std::string pointMaps(const ItemResult &item);

} // namespace grader
