// SPDX-License-Identifier: MIT
#include <nori/texture.h>

NORI_NAMESPACE_BEGIN

/// Checkerboard. As in Nori 2, both colours are read from `color`: giving it makes all cells alike.
class Checkerboard : public Texture {
public:
    Checkerboard(const PropertyList &props)
        : m_color1(props.getColor("color", Color3f(0.9f))),
          m_color2(props.getColor("color", Color3f(0.1f))),
          m_scale(props.getInteger("scalex", 1), props.getInteger("scaley", 1)) {}

    Color3f eval(const Point2f &uv) const override {
        // Truncated towards 0 as in Nori 2, so the cells beside uv = 0 are of double width.
        const auto column = static_cast<int64_t>(uv.x() * static_cast<float>(m_scale.x()));
        const auto row = static_cast<int64_t>(uv.y() * static_cast<float>(m_scale.y()));
        return (column + row) % 2 == 0 ? m_color1 : m_color2;
    }

    std::string toString() const override {
        return tfm::format("Checkerboard[\n"
                           "  scale = %s,\n"
                           "  colors = %s, %s\n"
                           "]",
                           m_scale.toString(), m_color1.toString(), m_color2.toString());
    }

private:
    Color3f m_color1, m_color2;
    Vector2i m_scale; ///< cells per unit of u and v
};

NORI_REGISTER_CLASS(Checkerboard, "checker")

NORI_NAMESPACE_END
