// SPDX-License-Identifier: MIT
#pragma once

#include <nori/object.h>

NORI_NAMESPACE_BEGIN

/// Estimates the radiance that arrives along a ray.
class Integrator : public NoriObject {
public:
    /// Called once before rendering.
    virtual void preprocess(const Scene *scene) { (void)scene; }

    /// One sample of the incident radiance at ray.o from direction ray.d [W/(m^2 sr)]. Called from
    /// several threads at once, each with its own sampler.
    virtual Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const = 0;

    EClassType getClassType() const override { return EIntegrator; }
};

NORI_NAMESPACE_END
