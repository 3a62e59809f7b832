// SPDX-License-Identifier: MIT
#pragma once

#include <nori/object.h>

NORI_NAMESPACE_BEGIN

/// A colour that varies over a surface.
class Texture : public NoriObject {
public:
    /// Colour at the texture coordinates `uv`.
    virtual Color3f eval(const Point2f &uv) const = 0;

    EClassType getClassType() const override { return ETexture; }
};

/// The same colour everywhere (property `color`, default 0.5).
class ConstantSpectrumTexture : public Texture {
public:
    ConstantSpectrumTexture(const PropertyList &props) : m_color(props.getColor("color", 0.5f)) {}

    ConstantSpectrumTexture(const Color3f &color) : m_color(color) {}

    Color3f eval(const Point2f &) const override { return m_color; }

    std::string toString() const override {
        return tfm::format("ConstantSpectrumTexture[ color = %s ]", m_color.toString());
    }

private:
    Color3f m_color;
};

NORI_NAMESPACE_END
