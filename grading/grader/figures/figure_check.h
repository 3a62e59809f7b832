// SPDX-License-Identifier: MIT
#pragma once

#include <grader/figures/figure_scenes.h>
#include <grader/images/read_image.h>
#include <grader/prober/prober.h>
#include <grader/results/results.h>
#include <grader/submission/submission.h>

#include <functional>
#include <string>
#include <vector>

namespace grader {

/// What figures are compared with.
struct FigureCheck {
    const FigureScenes &scenes;
    std::string seed; ///< any text: the same text, the same patches and samples

    /// Decodes a file; asks the hand-in's own code. Both may be called by several threads.
    std::function<ImageReading(std::string_view bytes)> decode;
    std::function<ProbeAnswer(const protocol::RequestGroup &group)> ask;

    int jobs = 1;                         ///< figures that are compared at the same time
    std::function<void(double)> progress; ///< fraction that is done; may throw to stop
};

/// Compares every figure of a hand-in with renders by the hand-in's own code of the scene that it
/// is named after, patch by patch at the samples that it states, and lists those that are missing.
std::vector<FigureResult> checkFigures(const Submission &submission, const FigureCheck &check);

} // namespace grader
