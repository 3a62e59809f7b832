// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace catalog {

/// A point of the unit square.
struct Square {
    double u = 0.0;
    double v = 0.0;
};

/// A point of a warp's domain: in the plane (z is 0 and ignored) or a unit direction.
struct Point {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

/// How far a point may leave the support through rounding, in units of the coordinates.
inline constexpr double kSupportTolerance = 1e-6;
/// How far the norm of a direction may be from 1.
inline constexpr double kNormTolerance = 1e-5;
/// Within this distance of the boundary a density may take either side's value.
inline constexpr double kBoundaryBand = 1e-5;
/// Rounding unit of single precision.
inline constexpr double kFloatRounding = 0x1p-24;

/// One warp: what is true of every right implementation, whatever map it uses. `a` is the warp's
/// parameter (Beckmann's alpha) and ignored by warps without one.
struct WarpEntry {
    std::string_view id;                ///< "triangle"
    std::string_view rubricId;          ///< "warp.triangle"; empty for warps that are not graded
    std::string_view warpFunction;      ///< "Warp::squareToUniformTriangle"
    std::string_view densityFunction;   ///< "Warp::squareToUniformTrianglePdf"
    int dimension;                      ///< 2: plane, area measure; 3: directions, solid angle
    bool hasParameter;                  ///< the functions take `a` as their second argument
    std::span<const double> parameters; ///< values of `a` to test; never empty

    /// Density by its formula, continued beyond the support (where the true density is 0).
    double (*formula)(const Point &p, double a);
    /// An exact warp, in double.
    Point (*warp)(const Square &s, double a);
    /// Rosenblatt map: uniform on the unit square for every right warp, and inverse of `warp`.
    /// Not clamped, and anything for points far outside the support.
    Square (*rosenblatt)(const Point &p, double a);
    /// Condition number of the density: relative change per relative change of a coordinate.
    double (*conditioning)(const Point &p, double a);
    /// Signed distance to the boundary of the support, positive inside. Looks at directions only,
    /// not at their norm.
    double (*margin)(const Point &p);
    /// The enlarged domain, on which the density is tried outside of its support: maps the unit
    /// square to it uniformly.
    Point (*enlarged)(const Square &s);
    double enlargedMeasure; ///< area or solid angle of the enlarged domain
    /// Point number t in [0, 1) of the boundary of the support; null if there is none.
    Point (*boundary)(double t);

    /// The density: `formula` inside the support (margin >= 0), else 0.
    [[nodiscard]] double density(const Point &p, double a) const {
        return margin(p) >= 0.0 ? formula(p, a) : 0.0;
    }
};

/// Where an output stands with regard to the domain.
enum class Placement { Inside, NotFinite, OffNorm, Outside };

/// Judges one output, with the tolerances above.
Placement placement(const WarpEntry &entry, const Point &p);

/// Change of U per unit of rounding where a warp builds the sine from a rounded cosine: 2 / a^2
/// for Beckmann, 0 for the others.
double edgeConditioning(const WarpEntry &entry, double a);

/// Tolerated rms relative density error in a histogram with `uBins` cells along U: 0.3 %, or what
/// rounding to single precision explains: uBins * 2^-24 * edgeConditioning().
double distributionTolerance(const WarpEntry &entry, double a, int uBins);

/// Tolerated largest smooth moment with `side`^2 stratified inputs. 5e-4 (three times above the
/// noise of any right warp) from side 1024 on, growing as side^-1.5 below it, since the noise of
/// maps with creases does; or four times what rounding explains.
double stratifiedTolerance(const WarpEntry &entry, double a, int side);

/// Symmetries of the domain under which a right warp stays right (for a mistake that may have been
/// made along any axis): `symmetry(entry, p, k)` for k in [0, symmetryCount(entry)), 0 = identity.
int symmetryCount(const WarpEntry &entry);
Point symmetry(const WarpEntry &entry, const Point &p, int k);

} // namespace catalog
