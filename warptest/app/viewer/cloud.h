// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <viewer/settings.h>
#include <viewer/subject.h>

namespace viewer {

/// Points of the unit square and what became of them. After an error the arrays hold what there
/// was until then: all of the same length, or empty.
struct Cloud {
    std::vector<battery::Input> inputs;
    std::vector<battery::Output> outputs;
    std::vector<float> densities; ///< as returned, at the outputs
    std::vector<double> exact;    ///< true densities there
    std::size_t outside = 0;      ///< outputs out of the domain, or not finite
    std::string warpError;        ///< what the warp threw; empty: nothing
    std::string densityError;     ///< what the density threw
    double milliseconds = 0.0;    ///< in the warp
    /// The warped grid: polylines of kGridSteps + 1 points, kGridLines + 1 along u, then along v.
    std::vector<battery::Output> gridLines;
    std::vector<battery::Output> boundary; ///< of the support, closed; empty if it has none
};

inline constexpr int kGridLines = 16;
inline constexpr int kGridSteps = 32;

/// The inputs that the settings ask for.
std::vector<battery::Input> makeInputs(const Settings &settings);

/// Draws the points; never throws what the subject throws.
Cloud makeCloud(const Subject &subject, const Settings &settings);

/// Relative error of a returned density.
double densityError(double returned, double exact);

} // namespace viewer
