// SPDX-License-Identifier: MIT
#pragma once

#include <nori/ray.h>

NORI_NAMESPACE_BEGIN

/// Homogeneous transformation that keeps its inverse.
struct Transform {
public:
    /// The identity.
    Transform()
        : m_transform(Eigen::Matrix4f::Identity()), m_inverse(Eigen::Matrix4f::Identity()) {}

    /// Inverts `trafo`; a singular matrix gives an inverse that is not finite.
    Transform(const Eigen::Matrix4f &trafo);

    Transform(const Eigen::Matrix4f &trafo, const Eigen::Matrix4f &inv)
        : m_transform(trafo), m_inverse(inv) {}

    const Eigen::Matrix4f &getMatrix() const { return m_transform; }

    const Eigen::Matrix4f &getInverseMatrix() const { return m_inverse; }

    Transform inverse() const { return Transform(m_inverse, m_transform); }

    /// Applies `t` first, then this one.
    Transform operator*(const Transform &t) const;

    Vector3f operator*(const Vector3f &v) const { return m_transform.topLeftCorner<3, 3>() * v; }

    /// By the inverse transpose; the result is not normalised.
    Normal3f operator*(const Normal3f &n) const {
        return m_inverse.topLeftCorner<3, 3>().transpose() * n;
    }

    /// Divides by the homogeneous coordinate.
    Point3f operator*(const Point3f &p) const {
        const Eigen::Vector4f result = m_transform * Eigen::Vector4f(p.x(), p.y(), p.z(), 1.0f);
        return result.head<3>() / result.w();
    }

    /// Keeps mint and maxt; the direction is not normalised.
    Ray3f operator*(const Ray3f &r) const {
        return Ray3f(operator*(r.o), operator*(r.d), r.mint, r.maxt);
    }

    std::string toString() const;

private:
    Eigen::Matrix4f m_transform;
    Eigen::Matrix4f m_inverse;
};

NORI_NAMESPACE_END
