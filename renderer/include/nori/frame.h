// SPDX-License-Identifier: MIT
#pragma once

#include <nori/vector.h>

NORI_NAMESPACE_BEGIN

/// Orthonormal basis at a surface point. The angle functions take unit vectors in local
/// coordinates, where the normal is +z; theta is the angle to it, phi the azimuth from +x.
struct Frame {
    Vector3f s, t; ///< tangents
    Normal3f n;    ///< normal

    Frame() = default;

    Frame(const Vector3f &s_, const Vector3f &t_, const Normal3f &n_) : s(s_), t(t_), n(n_) {}

    Frame(const Vector3f &x, const Vector3f &y, const Vector3f &z) : s(x), t(y), n(z) {}

    /// Any tangents that complete the unit vector `n_`.
    Frame(const Vector3f &n_) : n(n_) { coordinateSystem(n_, s, t); }

    Vector3f toLocal(const Vector3f &v) const { return Vector3f(v.dot(s), v.dot(t), v.dot(n)); }

    Vector3f toWorld(const Vector3f &v) const { return s * v.x() + t * v.y() + n * v.z(); }

    static float cosTheta(const Vector3f &v) { return v.z(); }

    static float sinTheta2(const Vector3f &v) { return 1.0f - v.z() * v.z(); }

    static float sinTheta(const Vector3f &v) {
        const float square = sinTheta2(v);
        return square <= 0.0f ? 0.0f : sqrtf(square);
    }

    static float tanTheta(const Vector3f &v) {
        const float square = sinTheta2(v);
        return square <= 0.0f ? 0.0f : sqrtf(square) / v.z();
    }

    /// 1 at the pole, like cosPhi(): phi is undefined there.
    static float sinPhi(const Vector3f &v) {
        const float sine = sinTheta(v);
        return sine == 0.0f ? 1.0f : clamp(v.y() / sine, -1.0f, 1.0f);
    }

    static float cosPhi(const Vector3f &v) {
        const float sine = sinTheta(v);
        return sine == 0.0f ? 1.0f : clamp(v.x() / sine, -1.0f, 1.0f);
    }

    static float sinPhi2(const Vector3f &v) {
        const float sine = sinPhi(v);
        return sine * sine;
    }

    static float cosPhi2(const Vector3f &v) {
        const float cosine = cosPhi(v);
        return cosine * cosine;
    }

    bool operator==(const Frame &frame) const {
        return frame.s == s && frame.t == t && frame.n == n;
    }

    bool operator!=(const Frame &frame) const { return !operator==(frame); }

    std::string toString() const {
        return tfm::format("Frame[\n"
                           "  s = %s,\n"
                           "  t = %s,\n"
                           "  n = %s\n"
                           "]",
                           s.toString(), t.toString(), n.toString());
    }
};

NORI_NAMESPACE_END
