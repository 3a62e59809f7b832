// SPDX-License-Identifier: MIT
#pragma once

#include <grader/images/comparison.h>

namespace grader {

/// Gives the verdict of a comparison whose channels have all been tested, with its reasons and the
/// p-value of all statistics together (Bonferroni over channels and statistics).
///
/// Different: a statistic is beyond the significance; tiles beyond the skewness gate are left out.
/// Alike: none is, and the bounds rule out an error of 1 % of the mean and, in 95 % of the tiles,
/// one of 15 % (of the tile, at least of a twentieth of the image's mean). Images that share their
/// noise are never alike by test.
void judge(Comparison &comparison, double significance);

} // namespace grader
