// SPDX-License-Identifier: MIT
#pragma once

#include <nori/common.h>

NORI_NAMESPACE_BEGIN

/// Linear RGB radiance, reflectance or weight. All arithmetic is per component.
struct Color3f : public Eigen::Array3f {
    typedef Eigen::Array3f Base;

    /// All components alike.
    Color3f(float value = 0.0f) : Base(value, value, value) {}

    Color3f(float r, float g, float b) : Base(r, g, b) {}

    template <typename Derived>
    Color3f(const Eigen::ArrayBase<Derived> &p) : Base(p) {}

    template <typename Derived>
    Color3f &operator=(const Eigen::ArrayBase<Derived> &p) {
        this->Base::operator=(p);
        return *this;
    }

    float &r() { return x(); }

    const float &r() const { return x(); }

    float &g() { return y(); }

    const float &g() const { return y(); }

    float &b() { return z(); }

    const float &b() const { return z(); }

    /// Negative components become 0.
    Color3f clamp() const {
        return Color3f(std::max(r(), 0.0f), std::max(g(), 0.0f), std::max(b(), 0.0f));
    }

    /// False if a component is negative, infinite or not a number.
    bool isValid() const;

    /// Undoes the sRGB curve.
    Color3f toLinearRGB() const;

    /// Applies the sRGB curve (IEC 61966-2-1); values above 1 are not clamped.
    Color3f toSRGB() const;

    /// 0.212671 r + 0.715160 g + 0.072169 b (ITU-R BT.709).
    float getLuminance() const;

    /// "[r, g, b]"
    std::string toString() const { return tfm::format("[%f, %f, %f]", r(), g(), b()); }
};

/// RGB sums of an image block, each already multiplied by its filter weight; the 4th component is
/// the sum of the weights.
struct Color4f : public Eigen::Array4f {
    typedef Eigen::Array4f Base;

    Color4f() : Base(0.0f, 0.0f, 0.0f, 0.0f) {}

    /// Weight 1.
    Color4f(const Color3f &c) : Base(c.r(), c.g(), c.b(), 1.0f) {}

    Color4f(float r, float g, float b, float w) : Base(r, g, b, w) {}

    template <typename Derived>
    Color4f(const Eigen::ArrayBase<Derived> &p) : Base(p) {}

    template <typename Derived>
    Color4f &operator=(const Eigen::ArrayBase<Derived> &p) {
        this->Base::operator=(p);
        return *this;
    }

    /// The weighted mean, or black where no sample has landed.
    Color3f divideByFilterWeight() const {
        if (w() == 0.0f)
            return Color3f(0.0f);
        return head<3>() / w();
    }

    /// "[r, g, b, w]"
    std::string toString() const {
        return tfm::format("[%f, %f, %f, %f]", coeff(0), coeff(1), coeff(2), coeff(3));
    }
};

NORI_NAMESPACE_END
