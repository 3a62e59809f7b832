// SPDX-License-Identifier: MIT
#include <nori/bsdf.h>
#include <nori/integrator.h>
#include <nori/sampler.h>

#include "direct_light.h"

NORI_NAMESPACE_BEGIN

/// Direct light, estimated by sampling the BSDF and looking what lies there; emitters are visible.
/// It uses neither Emitter::sample() nor any density, so it checks `direct_ems` independently.
/// Cannot see point lights, which no ray hits: they contribute nothing.
class DirectMaterialSampling : public Integrator {
public:
    DirectMaterialSampling(const PropertyList &) {}

    void preprocess(const Scene *scene) override {
        for (const Emitter *emitter : scene->getLights()) {
            if (emitter->isDelta()) {
                cerr << "direct_mats: point lights give no light here, because no ray hits them\n";
                return;
            }
        }
    }

    Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const override {
        const DirectLight seen(*scene, ray);
        if (!seen.isHit)
            return seen.radiance;
        const Intersection &its = seen.its;
        BSDFQueryRecord bRec(its.toLocal(-ray.d.normalized()), its.uv);
        const Color3f weight = its.mesh->getBSDF()->sample(bRec, sampler->next2D());
        if ((weight == 0.0f).all())
            return seen.radiance;
        const DirectLight incident(*scene, Ray3f(its.p, its.toWorld(bRec.wo)));
        return seen.radiance + weight * incident.radiance;
    }

    std::string toString() const override { return "DirectMaterialSampling[]"; }
};

NORI_REGISTER_CLASS(DirectMaterialSampling, "direct_mats")

NORI_NAMESPACE_END
