// SPDX-License-Identifier: MIT
#pragma once

#include <battery/distribution.h>
#include <battery/maps.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace viewer {

enum class PointSet { Independent, Grid, Stratified, Halton };
inline constexpr std::array<const char *, 4> kPointSetNames{"independent", "grid", "stratified",
                                                            "halton"};

enum class ColorBy { Plain, Density, Order, Error };
inline constexpr std::array<const char *, 4> kColorByNames{"nothing", "density", "order",
                                                           "|density error|"};

/// Points that are shown: the slider goes by powers of two, typed numbers may be anything between.
inline constexpr int kMinLogCount = 5;
inline constexpr int kMaxLogCount = 22;

/// What the controls say. Equal settings give equal points and equal results.
struct Settings {
    std::size_t warp = 0;   ///< index into the subjects
    double parameter = 0.0; ///< of the warp; ignored by warps without one
    PointSet points = PointSet::Independent;
    std::size_t count = std::size_t{1} << 14U; ///< grids and strata take the next smaller square
    std::uint64_t seed = 1;
    int rows = battery::kMapSide;                        ///< and columns of the maps
    std::size_t samples = battery::kDistributionSamples; ///< of a test's first stage
    double significance = 1e-4;                          ///< of a test
    int repeats = 1;                                     ///< whole tests on fresh random numbers
    bool grid = true;                                    ///< the warped grid over the points
    ColorBy colorBy = ColorBy::Density;

    bool operator==(const Settings &other) const = default;
};

/// Parameters a window lets one choose: (0, 1].
inline constexpr double kMinParameter = 0.01;
inline constexpr double kMaxParameter = 1.0;

/// The settings with every number in its range; `subjects` is the number of subjects.
Settings clamped(Settings settings, std::size_t subjects);

} // namespace viewer
