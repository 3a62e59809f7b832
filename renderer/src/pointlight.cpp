// SPDX-License-Identifier: MIT
#include <nori/emitter.h>

NORI_NAMESPACE_BEGIN

/// Light from a single point, the same in all directions.
class PointEmitter : public Emitter {
public:
    PointEmitter(const PropertyList &props)
        : m_position(props.getPoint("position", Point3f(0.0f, 100.0f, 0.0f))),
          m_radiance(props.getColor("radiance", Color3f(1.0f))) {
        m_type = EmitterType::EMITTER_POINT;
    }

    /// Never drawn twice differently, so the density is 1 by convention.
    Color3f sample(EmitterQueryRecord &lRec, const Point2f &, float) const override {
        lRec.emitter = this;
        lRec.p = m_position;
        lRec.uv = Point2f(0.0f);
        lRec.wi = m_position - lRec.ref;
        lRec.dist = lRec.wi.norm();
        lRec.wi /= lRec.dist;
        lRec.n = -lRec.wi;
        lRec.pdf = 1.0f;
        if (lRec.dist == 0.0f) // the light sits on the surface: there is no direction to it
            return Color3f(0.0f);
        return m_radiance / (lRec.dist * lRec.dist);
    }

    float pdf(const EmitterQueryRecord &) const override { return 1.0f; }

    /// Black: no ray can hit a point.
    Color3f eval(const EmitterQueryRecord &) const override { return Color3f(0.0f); }

    // These three are no overrides: submissions add pure virtual functions of these names.
    Color3f radiance() const { return m_radiance; }

    // NOLINTNEXTLINE(modernize-use-override): see above
    Color3f power() const { return 4.0f * M_PI * m_radiance; }

    float getLuminance() const { return m_radiance.getLuminance(); }

    std::string toString() const override {
        return tfm::format("PointEmitter[\n"
                           "  position = %s,\n"
                           "  radiance = %s\n"
                           "]",
                           m_position.toString(), m_radiance.toString());
    }

private:
    Point3f m_position;
    Color3f m_radiance; ///< really an intensity [W/sr]; Nori 2 calls it so
};

NORI_REGISTER_CLASS(PointEmitter, "pointlight")

NORI_NAMESPACE_END
