// SPDX-License-Identifier: MIT
#pragma once

#include <nori/object.h>

NORI_NAMESPACE_BEGIN

/// Question to a BSDF. All directions are in local coordinates and point away from the surface.
struct BSDFQueryRecord {
    Vector3f wi;      ///< towards the viewer
    Vector3f wo;      ///< towards the light; set by BSDF::sample()
    float eta;        ///< relative refractive index in the sampled direction
    Vector2f uv;      ///< texture coordinates
    EMeasure measure; ///< of wo

    /// For sampling.
    BSDFQueryRecord(const Vector3f &wi_, const Vector2f &uv_ = Vector2f())
        : wi(wi_), eta(1.0f), uv(uv_), measure(EUnknownMeasure) {}

    /// For evaluation.
    BSDFQueryRecord(const Vector3f &wi_, const Vector3f &wo_, const Vector2f &uv_,
                    EMeasure measure_)
        : wi(wi_), wo(wo_), eta(1.0f), uv(uv_), measure(measure_) {}
};

/// How a surface scatters light.
class BSDF : public NoriObject {
public:
    /// Draws bRec.wo. \return value times cosine over density; black where nothing is scattered
    virtual Color3f sample(BSDFQueryRecord &bRec, const Point2f &sample) const = 0;

    /// Value without the cosine [1/sr]; black for another measure than the BSDF's.
    virtual Color3f eval(const BSDFQueryRecord &bRec) const = 0;

    /// Density with which sample() draws bRec.wo [1/sr].
    virtual float pdf(const BSDFQueryRecord &bRec) const = 0;

    virtual bool isDiffuse() const { return false; }

    EClassType getClassType() const override { return EBSDF; }
};

NORI_NAMESPACE_END
