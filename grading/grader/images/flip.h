// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/image.h>

#include <vector>

namespace grader {

/// How different two images look when flipped between, per pixel in [0, 1]: LDR-FLIP of the images
/// as nori's PNGs show them (clamped to [0, 1]).
/// \param a, b             images of one size with channels R, G, B in linear light, finite
/// \param pixelsPerDegree  of the observer's view; 67: 0.7 m from a 0.7 m wide 4K monitor
/// \see P. Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM
///      Comput. Graph. Interact. Tech. 3(2), 2020.
std::vector<float> flip(const protocol::Image &a, const protocol::Image &b,
                        double pixelsPerDegree = 67.0);

} // namespace grader
