// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

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

/// One target: what is true of every right warp to it, whatever map it uses. `a` is the warp's
/// parameter (Beckmann's alpha) and ignored by warps without one.
struct WarpEntry {
    std::string id{};                    ///< "triangle"
    std::string rubricId{};              ///< "warp.triangle"; empty for warps that are not graded
    std::string warpFunction{};          ///< "Warp::squareToUniformTriangle"
    std::string densityFunction{};       ///< "Warp::squareToUniformTrianglePdf"
    int dimension = 2;                   ///< 2: plane, area measure; 3: directions, solid angle
    bool hasParameter = false;           ///< the functions take `a` as their second argument
    std::vector<double> parameters{0.0}; ///< values of `a` to test; never empty

    /// Density by its formula, continued beyond the support (where the true density is 0).
    std::function<double(const Point &p, double a)> formula{};
    /// An exact warp, in double.
    std::function<Point(const Square &s, double a)> warp{};
    /// Rosenblatt map: uniform on the unit square for every right warp, and inverse of `warp`.
    /// Not clamped, and anything for points far outside the support.
    std::function<Square(const Point &p, double a)> rosenblatt{};
    /// Condition number of the density: relative change per relative change of a coordinate.
    std::function<double(const Point &p, double a)> conditioning{};
    /// Signed distance to the boundary of the support, positive inside. Looks at directions only,
    /// not at their norm.
    std::function<double(const Point &p)> margin{};
    /// The enlarged domain, on which the density is tried outside of its support: maps the unit
    /// square to it uniformly.
    std::function<Point(const Square &s)> enlarged{};
    double enlargedMeasure = 1.0; ///< area or solid angle of the enlarged domain
    /// Point number t in [0, 1) of the boundary of the support; null if there is none.
    std::function<Point(double t)> boundary{};
    /// Change of U per unit of rounding of a coordinate in a right but unlucky implementation,
    /// beyond which nothing is an error: 2 / a^2 where Beckmann's sine is built from a rounded
    /// cosine. Null: 0.
    std::function<double(double a)> edgeConditioning{};

    /// The density: `formula` inside the support (margin >= 0), else 0.
    [[nodiscard]] double density(const Point &p, double a) const {
        return margin(p) >= 0.0 ? formula(p, a) : 0.0;
    }
};

/// Where an output stands with regard to the domain.
enum class Placement { Inside, NotFinite, OffNorm, Outside };

/// Judges one output, with the tolerances above.
Placement placement(const WarpEntry &entry, const Point &p);

/// `entry.edgeConditioning`, or 0.
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
