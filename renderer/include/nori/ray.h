// SPDX-License-Identifier: MIT
#pragma once

#include <nori/vector.h>

NORI_NAMESPACE_BEGIN

/// A segment o + t d with t in [mint, maxt]. `d` is not normalised here; t is in units of its
/// length. After changing `d`, call update().
template <typename PointT, typename VectorT>
struct TRay {
    typedef PointT PointType;
    typedef VectorT VectorType;
    typedef typename PointType::Scalar Scalar;

    PointType o;     ///< origin
    VectorType d;    ///< direction
    VectorType dRcp; ///< component-wise reciprocal of d
    Scalar mint;     ///< start of the segment
    Scalar maxt;     ///< end of the segment

    TRay() : mint(Epsilon), maxt(std::numeric_limits<Scalar>::infinity()) {}

    /// The segment [Epsilon, infinity).
    TRay(const PointType &o_, const VectorType &d_)
        : o(o_), d(d_), mint(Epsilon), maxt(std::numeric_limits<Scalar>::infinity()) {
        update();
    }

    TRay(const PointType &o_, const VectorType &d_, Scalar mint_, Scalar maxt_)
        : o(o_), d(d_), mint(mint_), maxt(maxt_) {
        update();
    }

    TRay(const TRay &ray) = default;
    TRay &operator=(const TRay &ray) = default;

    /// The same line with another segment.
    TRay(const TRay &ray, Scalar mint_, Scalar maxt_)
        : o(ray.o), d(ray.d), dRcp(ray.dRcp), mint(mint_), maxt(maxt_) {}

    /// Recomputes dRcp from d.
    void update() { dRcp = d.cwiseInverse(); }

    PointType operator()(Scalar t) const { return o + t * d; }

    /// The same segment bounds in the opposite direction.
    TRay reverse() const { return TRay(o, -d, mint, maxt); }

    std::string toString() const {
        return tfm::format("Ray[\n"
                           "  o = %s,\n"
                           "  d = %s,\n"
                           "  mint = %f,\n"
                           "  maxt = %f\n"
                           "]",
                           o.toString(), d.toString(), mint, maxt);
    }
};

NORI_NAMESPACE_END
