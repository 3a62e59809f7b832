// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace preview {

/// Samples per pixel of the passes that show the whole image before its blocks are rendered: 1, 1,
/// 2, 4 ..., together a 16th of the image's own samples at most, but one at least. None for an
/// image of fewer than 4, which is there as soon.
std::vector<int> passSchedule(int samplesPerPixel);

} // namespace preview
