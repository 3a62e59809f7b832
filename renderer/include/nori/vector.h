// SPDX-License-Identifier: MIT
#pragma once

#include <nori/common.h>

NORI_NAMESPACE_BEGIN

/// A direction or displacement. Default-constructed: zero. Converts to and from a point.
template <typename ScalarT, int DimensionT>
struct TVector : public Eigen::Matrix<ScalarT, DimensionT, 1> {
    enum { Dimension = DimensionT };

    typedef ScalarT Scalar;
    typedef Eigen::Matrix<Scalar, DimensionT, 1> Base;
    typedef TVector<Scalar, DimensionT> VectorType;
    typedef TPoint<Scalar, DimensionT> PointType;

    /// All components alike.
    TVector(Scalar value = static_cast<Scalar>(0)) { Base::setConstant(value); }

    TVector(Scalar x, Scalar y) : Base(x, y) {}

    TVector(Scalar x, Scalar y, Scalar z) : Base(x, y, z) {}

    TVector(Scalar x, Scalar y, Scalar z, Scalar w) : Base(x, y, z, w) {}

    template <typename Derived>
    TVector(const Eigen::MatrixBase<Derived> &p) : Base(p) {}

    template <typename Derived>
    TVector &operator=(const Eigen::MatrixBase<Derived> &p) {
        this->Base::operator=(p);
        return *this;
    }

    /// "[x, y, z]"
    std::string toString() const {
        std::ostringstream out;
        for (int i = 0; i < DimensionT; ++i)
            out << (i == 0 ? "[" : ", ") << this->coeff(i);
        out << "]";
        return out.str();
    }
};

/// A position. Default-constructed: the origin. Converts to and from a vector.
template <typename ScalarT, int DimensionT>
struct TPoint : public Eigen::Matrix<ScalarT, DimensionT, 1> {
    enum { Dimension = DimensionT };

    typedef ScalarT Scalar;
    typedef Eigen::Matrix<Scalar, DimensionT, 1> Base;
    typedef TVector<Scalar, DimensionT> VectorType;
    typedef TPoint<Scalar, DimensionT> PointType;

    /// All components alike.
    TPoint(Scalar value = static_cast<Scalar>(0)) { Base::setConstant(value); }

    TPoint(Scalar x, Scalar y) : Base(x, y) {}

    TPoint(Scalar x, Scalar y, Scalar z) : Base(x, y, z) {}

    TPoint(Scalar x, Scalar y, Scalar z, Scalar w) : Base(x, y, z, w) {}

    template <typename Derived>
    TPoint(const Eigen::MatrixBase<Derived> &p) : Base(p) {}

    template <typename Derived>
    TPoint &operator=(const Eigen::MatrixBase<Derived> &p) {
        this->Base::operator=(p);
        return *this;
    }

    /// "[x, y, z]"
    std::string toString() const { return VectorType(*this).toString(); }
};

/// A surface normal: unlike a vector, it is transformed by the inverse transpose.
struct Normal3f : public Eigen::Matrix<float, 3, 1> {
    enum { Dimension = 3 };

    typedef float Scalar;
    typedef Eigen::Matrix<float, 3, 1> Base;
    typedef TVector<float, 3> VectorType;
    typedef TPoint<float, 3> PointType;

    /// All components alike.
    Normal3f(Scalar value = 0.0f) { Base::setConstant(value); }

    Normal3f(Scalar x, Scalar y, Scalar z) : Base(x, y, z) {}

    template <typename Derived>
    Normal3f(const Eigen::MatrixBase<Derived> &p) : Base(p) {}

    template <typename Derived>
    Normal3f &operator=(const Eigen::MatrixBase<Derived> &p) {
        this->Base::operator=(p);
        return *this;
    }

    /// "[x, y, z]"
    std::string toString() const { return VectorType(*this).toString(); }
};

/// Completes the unit vector `a` to an orthonormal basis (a, b, c).
extern void coordinateSystem(const Vector3f &a, Vector3f &b, Vector3f &c);

NORI_NAMESPACE_END
