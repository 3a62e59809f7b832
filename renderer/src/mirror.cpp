// SPDX-License-Identifier: MIT
#include <nori/bsdf.h>
#include <nori/frame.h>

NORI_NAMESPACE_BEGIN

/// Ideal mirror. Its value is a delta function, so eval() and pdf() are 0.
class Mirror : public BSDF {
public:
    Mirror(const PropertyList &) {}

    Color3f eval(const BSDFQueryRecord &) const override { return Color3f(0.0f); }

    float pdf(const BSDFQueryRecord &) const override { return 0.0f; }

    Color3f sample(BSDFQueryRecord &bRec, const Point2f &) const override {
        if (Frame::cosTheta(bRec.wi) <= 0.0f)
            return Color3f(0.0f);
        bRec.wo = Vector3f(-bRec.wi.x(), -bRec.wi.y(), bRec.wi.z());
        bRec.measure = EDiscrete;
        bRec.eta = 1.0f;
        return Color3f(1.0f);
    }

    std::string toString() const override { return "Mirror[]"; }
};

NORI_REGISTER_CLASS(Mirror, "mirror")

NORI_NAMESPACE_END
