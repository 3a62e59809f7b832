// SPDX-License-Identifier: MIT
#include <nori/bsdf.h>
#include <nori/frame.h>
#include <nori/texture.h>
#include <nori/warp.h>

#include <memory>

NORI_NAMESPACE_BEGIN

/// Scatters alike in all directions of the side it is seen from (Lambert).
class Diffuse : public BSDF {
public:
    Diffuse(const PropertyList &props)
        : m_albedo(new ConstantSpectrumTexture(props.getColor("albedo", Color3f(0.5f)))) {}

    void addChild(NoriObject *child, const std::string &name) override {
        if (child->getClassType() != ETexture || name != "albedo")
            throw NoriException("Diffuse::addChild(<%s name=\"%s\">) is not supported; only a "
                                "texture called \"albedo\"!",
                                classTypeName(child->getClassType()), name);
        m_albedo.reset(static_cast<Texture *>(child));
    }

    Color3f eval(const BSDFQueryRecord &bRec) const override {
        return scatters(bRec) ? Color3f(m_albedo->eval(bRec.uv) * INV_PI) : Color3f(0.0f);
    }

    float pdf(const BSDFQueryRecord &bRec) const override {
        return scatters(bRec) ? INV_PI * Frame::cosTheta(bRec.wo) : 0.0f;
    }

    Color3f sample(BSDFQueryRecord &bRec, const Point2f &sample) const override {
        if (Frame::cosTheta(bRec.wi) <= 0.0f)
            return Color3f(0.0f);
        bRec.measure = ESolidAngle;
        bRec.wo = Warp::squareToCosineHemisphere(sample);
        bRec.eta = 1.0f;
        return m_albedo->eval(bRec.uv); // value times cosine over density
    }

    bool isDiffuse() const override { return true; }

    std::string toString() const override {
        return tfm::format("Diffuse[\n"
                           "  albedo = %s\n"
                           "]",
                           indent(m_albedo->toString()));
    }

private:
    static bool scatters(const BSDFQueryRecord &bRec) {
        return bRec.measure == ESolidAngle && Frame::cosTheta(bRec.wi) > 0.0f &&
               Frame::cosTheta(bRec.wo) > 0.0f;
    }

    std::unique_ptr<Texture> m_albedo;
};

NORI_REGISTER_CLASS(Diffuse, "diffuse")

NORI_NAMESPACE_END
