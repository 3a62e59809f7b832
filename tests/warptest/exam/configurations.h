// SPDX-License-Identifier: MIT
#pragma once

#include <battery/battery.h>

#include <string>
#include <string_view>
#include <vector>

namespace warp_exam {

/// A warp with its density at one parameter, right or wrong.
struct Configuration {
    std::string name; ///< "triangle missing_root"
    const catalog::WarpEntry *target = nullptr;
    double a = 0.0;
    battery::Warp warp;
    battery::Density density;
    bool wrongWarp = false;
    bool wrongDensity = false;
    std::string_view equivalence{}; ///< why nothing is wrong at this parameter; empty: it is wrong
};

/// Every right sample warp with a right density, at every parameter.
std::vector<Configuration> rightConfigurations();

/// Every wrong sample warp and density, every mistake of the catalogue that has no sample, and
/// pairs that are wrong together, at every parameter.
std::vector<Configuration> wrongConfigurations();

/// How far a configuration is from the right one.
struct Distance {
    /// Of the points of equal samples, in probability mass: largest |U - u|, |V - v|.
    double warp = 0.0;
    /// Relative, of the density, exceeded at a thousandth of the samples.
    double density = 0.0;
    /// What rounding to single precision does to a right one.
    double warpTolerance = 0.0;
    double densityTolerance = 0.0;

    [[nodiscard]] bool isWithinRounding() const {
        return warp <= warpTolerance && density <= densityTolerance;
    }
};

/// Meaningful for warps that use their sample as the catalogue's do.
Distance distanceFromRight(const Configuration &configuration);

} // namespace warp_exam
