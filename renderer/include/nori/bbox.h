// SPDX-License-Identifier: MIT
#pragma once

#include <nori/ray.h>

NORI_NAMESPACE_BEGIN

/// Axis-aligned box. Default-constructed it is invalid (min = +max, max = lowest value, infinite
/// for floats), so that the first expandBy() makes it a point.
template <typename PointT>
struct TBoundingBox {
    enum { Dimension = PointT::Dimension };

    typedef PointT PointType;
    typedef typename PointType::Scalar Scalar;
    typedef typename PointType::VectorType VectorType;

    PointType min;
    PointType max;

    TBoundingBox() { reset(); }

    TBoundingBox(const PointType &p) : min(p), max(p) {}

    TBoundingBox(const PointType &min_, const PointType &max_) : min(min_), max(max_) {}

    bool operator==(const TBoundingBox &bbox) const { return min == bbox.min && max == bbox.max; }

    bool operator!=(const TBoundingBox &bbox) const { return !operator==(bbox); }

    Scalar getVolume() const { return (max - min).prod(); }

    /// Sum over the faces of the box: an area in 3-D, a perimeter in 2-D.
    Scalar getSurfaceArea() const {
        const VectorType extents = max - min;
        Scalar result = 0;
        for (int i = 0; i < Dimension; ++i) {
            Scalar term = 1;
            for (int j = 0; j < Dimension; ++j)
                term *= i == j ? Scalar(1) : extents[j];
            result += term;
        }
        return Scalar(2) * result;
    }

    PointType getCenter() const { return (max + min) * static_cast<Scalar>(0.5); }

    /// \param strict  points on the boundary do not count
    bool contains(const PointType &p, bool strict = false) const {
        if (strict)
            return (p.array() > min.array()).all() && (p.array() < max.array()).all();
        return (p.array() >= min.array()).all() && (p.array() <= max.array()).all();
    }

    bool contains(const TBoundingBox &bbox, bool strict = false) const {
        return contains(bbox.min, strict) && contains(bbox.max, strict);
    }

    bool overlaps(const TBoundingBox &bbox, bool strict = false) const {
        if (strict)
            return (bbox.min.array() < max.array()).all() && (bbox.max.array() > min.array()).all();
        return (bbox.min.array() <= max.array()).all() && (bbox.max.array() >= min.array()).all();
    }

    /// 0 for a point inside.
    Scalar squaredDistanceTo(const PointType &p) const {
        Scalar result = 0;
        for (int i = 0; i < Dimension; ++i) {
            const Scalar gap = std::max({min[i] - p[i], p[i] - max[i], Scalar(0)});
            result += gap * gap;
        }
        return result;
    }

    Scalar distanceTo(const PointType &p) const { return std::sqrt(squaredDistanceTo(p)); }

    Scalar squaredDistanceTo(const TBoundingBox &bbox) const {
        Scalar result = 0;
        for (int i = 0; i < Dimension; ++i) {
            const Scalar gap = std::max({min[i] - bbox.max[i], bbox.min[i] - max[i], Scalar(0)});
            result += gap * gap;
        }
        return result;
    }

    Scalar distanceTo(const TBoundingBox &bbox) const { return std::sqrt(squaredDistanceTo(bbox)); }

    bool isValid() const { return (max.array() >= min.array()).all(); }

    bool isPoint() const { return (max.array() == min.array()).all(); }

    bool hasVolume() const { return (max.array() > min.array()).all(); }

    /// Index of the longest side.
    int getMajorAxis() const {
        int longest = 0;
        getExtents().maxCoeff(&longest);
        return longest;
    }

    /// Index of the shortest side.
    int getMinorAxis() const {
        int shortest = 0;
        getExtents().minCoeff(&shortest);
        return shortest;
    }

    int getLargestAxis() const { return getMajorAxis(); }

    VectorType getExtents() const { return max - min; }

    /// Shrinks to the part inside `bbox`; invalid afterwards if they do not overlap.
    void clip(const TBoundingBox &bbox) {
        min = min.cwiseMax(bbox.min);
        max = max.cwiseMin(bbox.max);
    }

    void reset() {
        using Limits = std::numeric_limits<Scalar>;
        min.setConstant(Limits::has_infinity ? Limits::infinity() : Limits::max());
        max.setConstant(Limits::has_infinity ? -Limits::infinity() : Limits::lowest());
    }

    void expandBy(const PointType &p) {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }

    void expandBy(const TBoundingBox &bbox) {
        min = min.cwiseMin(bbox.min);
        max = max.cwiseMax(bbox.max);
    }

    static TBoundingBox merge(const TBoundingBox &bbox1, const TBoundingBox &bbox2) {
        return TBoundingBox(bbox1.min.cwiseMin(bbox2.min), bbox1.max.cwiseMax(bbox2.max));
    }

    /// Bit i of `index` chooses between min (0) and max (1) along axis i.
    PointType getCorner(int index) const {
        PointType result;
        for (int i = 0; i < Dimension; ++i)
            result[i] = (index & (1 << i)) != 0 ? max[i] : min[i];
        return result;
    }

    std::string toString() const {
        if (!isValid())
            return "BoundingBox[invalid]";
        return tfm::format("BoundingBox[min=%s, max=%s]", min.toString(), max.toString());
    }

    /// Whether the ray's segment touches the box.
    bool rayIntersect(const TRay<PointType, VectorType> &ray) const {
        Scalar nearT = 0, farT = 0;
        return rayIntersect(ray, nearT, farT) && ray.mint <= farT && nearT <= ray.maxt;
    }

    /// Where the whole line (its segment is ignored) enters and leaves the box.
    bool rayIntersect(const TRay<PointType, VectorType> &ray, Scalar &nearT, Scalar &farT) const {
        nearT = -std::numeric_limits<Scalar>::infinity();
        farT = std::numeric_limits<Scalar>::infinity();
        for (int i = 0; i < Dimension; ++i) {
            if (ray.d[i] == 0) {
                if (ray.o[i] < min[i] || ray.o[i] > max[i])
                    return false;
                continue;
            }
            const Scalar t1 = (min[i] - ray.o[i]) * ray.dRcp[i];
            const Scalar t2 = (max[i] - ray.o[i]) * ray.dRcp[i];
            nearT = std::max(nearT, std::min(t1, t2));
            farT = std::min(farT, std::max(t1, t2));
            if (!(nearT <= farT))
                return false;
        }
        return true;
    }
};

NORI_NAMESPACE_END
