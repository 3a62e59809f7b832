// SPDX-License-Identifier: MIT
#include <nori/bsdf.h>
#include <nori/frame.h>

NORI_NAMESPACE_BEGIN

/// Smooth boundary such as glass: reflects and refracts in one direction each. Its value is a sum
/// of delta functions, so eval() and pdf() are 0.
class Dielectric : public BSDF {
public:
    Dielectric(const PropertyList &props)
        : m_intIOR(props.getFloat("intIOR", 1.5046f)),
          m_extIOR(props.getFloat("extIOR", 1.000277f)) {
        if (!(m_intIOR > 0.0f && m_extIOR > 0.0f))
            throw NoriException("Properties 'intIOR' and 'extIOR' are %f and %f, must be positive!",
                                m_intIOR, m_extIOR);
    }

    Color3f eval(const BSDFQueryRecord &) const override { return Color3f(0.0f); }

    float pdf(const BSDFQueryRecord &) const override { return 0.0f; }

    /// Weight 1 either way: what is transported is radiance over the squared refractive index, so
    /// that nothing is scaled on entering and leaving.
    Color3f sample(BSDFQueryRecord &bRec, const Point2f &sample) const override {
        const float cosI = Frame::cosTheta(bRec.wi);
        bRec.measure = EDiscrete;
        bRec.eta = 1.0f;
        bRec.wo = Vector3f(-bRec.wi.x(), -bRec.wi.y(), cosI);
        if (sample.x() < fresnel(cosI, m_extIOR, m_intIOR))
            return Color3f(1.0f);

        const float eta = cosI >= 0.0f ? m_extIOR / m_intIOR : m_intIOR / m_extIOR;
        const float cosT = std::sqrt(std::max(0.0f, 1.0f - eta * eta * Frame::sinTheta2(bRec.wi)));
        bRec.wo = Vector3f(-eta * bRec.wi.x(), -eta * bRec.wi.y(), cosI >= 0.0f ? -cosT : cosT);
        bRec.eta = 1.0f / eta;
        return Color3f(1.0f);
    }

    std::string toString() const override {
        return tfm::format("Dielectric[\n"
                           "  intIOR = %f,\n"
                           "  extIOR = %f\n"
                           "]",
                           m_intIOR, m_extIOR);
    }

private:
    float m_intIOR,
        m_extIOR; ///< refractive index on the side away from the normal, and on its side
};

NORI_REGISTER_CLASS(Dielectric, "dielectric")

NORI_NAMESPACE_END
