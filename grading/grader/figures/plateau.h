// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/image.h>

#include <cstddef>
#include <vector>

namespace grader {

/// Where an image holds its largest value; none where hardly a pixel does: a clamped image has
/// many.
struct Plateau {
    float value = 0;
    std::vector<std::size_t> spots; ///< channel + 3 * pixel
};

/// \param image  with channels R, G and B
Plateau findPlateau(const protocol::Image &image);

} // namespace grader
