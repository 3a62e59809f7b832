// SPDX-License-Identifier: MIT
#pragma once

#include <grader/figures/figure_check.h>
#include <grader/figures/figure_test.h>
#include <protocol/image.h>

#include <optional>
#include <string>

namespace grader {

/// A figure's image and what its name and header say.
struct StatedFigure {
    const protocol::Image &image;
    FigureScenes::Found scene; ///< with a scene
    int samples = 0;           ///< per pixel; 0: not stated
};

/// Compares one figure with what the hand-in's code renders.
/// \param seed  any text, of this figure
/// \return      all but path, scene, samples and what concerns the name
FigureResult judgeFigure(const StatedFigure &figure, const FigureCheck &check,
                         const std::string &seed);

} // namespace grader
