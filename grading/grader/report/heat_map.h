// SPDX-License-Identifier: MIT
#pragma once

#include <battery/maps.h>

#include <string>

namespace grader {

/// Observed and expected counts with a common scale, and standardised residuals, as figures of a
/// page: inline SVG with colour bars, and captions that say in words what they show. No ids, no
/// styles of their own; the classes `maps` and `map` are in kPageStyle.
std::string mapFigures(const battery::Maps &maps);

/// "x 0.28, y 0.91": the centre of a cell.
std::string placeOf(const battery::Maps &maps, std::size_t cell);

} // namespace grader
