// SPDX-License-Identifier: MIT
#include <nori/bsdf.h>
#include <nori/integrator.h>
#include <nori/sampler.h>

#include "direct_light.h"

NORI_NAMESPACE_BEGIN

/// Direct light, estimated by one sample of an emitter and one of the BSDF, combined by the balance
/// heuristic; emitters are visible.
/// \see Veach and Guibas, "Optimally combining sampling techniques for Monte Carlo rendering", 1995
class DirectMultipleImportance : public Integrator {
public:
    DirectMultipleImportance(const PropertyList &) {}

    Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const override {
        const DirectLight seen(*scene, ray);
        if (!seen.isHit || scene->getLights().empty())
            return seen.radiance;
        const Vector3f wi = seen.its.toLocal(-ray.d.normalized());
        return seen.radiance + fromEmitter(*scene, *sampler, seen.its, wi) +
               fromBsdf(*scene, *sampler, seen.its, wi);
    }

    std::string toString() const override { return "DirectMultipleImportance[]"; }

private:
    /// \param wi  local direction towards the viewer
    static Color3f fromEmitter(const Scene &scene, Sampler &sampler, const Intersection &its,
                               const Vector3f &wi) {
        float choicePdf = 0.0f;
        const Emitter *emitter = scene.sampleEmitter(sampler.next1D(), choicePdf);
        EmitterQueryRecord lRec(its.p);
        const Point2f sample = sampler.next2D();
        const Color3f incident = emitter->sample(lRec, sample, sampler.next1D());
        if ((incident == 0.0f).all())
            return Color3f(0.0f);

        // as in direct_ems
        const float slack = std::max(1e-5f, 1e-6f * lRec.p.cwiseAbs().maxCoeff());
        if (scene.rayIntersect(Ray3f(its.p, lRec.wi, Epsilon, lRec.dist - slack)))
            return Color3f(0.0f);

        const BSDFQueryRecord bRec(wi, its.toLocal(lRec.wi), its.uv, ESolidAngle);
        const BSDF &bsdf = *its.mesh->getBSDF();
        const float cosTheta = std::max(0.0f, its.shFrame.n.dot(lRec.wi));
        // what no ray hits, the BSDF never finds
        const float bsdfPdf = emitter->isDelta() ? 0.0f : bsdf.pdf(bRec);
        const float emitterPdf = lRec.pdf * choicePdf;
        return incident * bsdf.eval(bRec) * cosTheta / choicePdf *
               (emitterPdf / (emitterPdf + bsdfPdf));
    }

    /// \param wi  local direction towards the viewer
    static Color3f fromBsdf(const Scene &scene, Sampler &sampler, const Intersection &its,
                            const Vector3f &wi) {
        const BSDF &bsdf = *its.mesh->getBSDF();
        BSDFQueryRecord bRec(wi, its.uv);
        const Color3f weight = bsdf.sample(bRec, sampler.next2D());
        if ((weight == 0.0f).all())
            return Color3f(0.0f);
        const DirectLight found(scene, Ray3f(its.p, its.toWorld(bRec.wo)));
        if ((found.radiance == 0.0f).all())
            return Color3f(0.0f);
        if (bRec.measure == EDiscrete) // a mirror's direction, which no emitter ever draws
            return weight * found.radiance;
        const float bsdfPdf = bsdf.pdf(bRec);
        const float emitterPdf = found.emitter->pdf(found.lRec) * scene.pdfEmitter(found.emitter);
        return weight * found.radiance * (bsdfPdf / (bsdfPdf + emitterPdf));
    }
};

NORI_REGISTER_CLASS(DirectMultipleImportance, "direct_mis")

NORI_NAMESPACE_END
