// SPDX-License-Identifier: MIT
#include <nori/bsdf.h>
#include <nori/emitter.h>
#include <nori/integrator.h>
#include <nori/sampler.h>
#include <nori/scene.h>

NORI_NAMESPACE_BEGIN

/// direct_ems with a mistake: shadow rays start 0.6 late, so that what touches a surface
/// throws no shadow near it.
class WideMargin : public Integrator {
public:
    WideMargin(const PropertyList &) {}

    Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const override {
        constexpr float kMargin = 0.6f;
        Intersection its;
        if (!scene->rayIntersect(ray, its))
            return scene->getBackground(ray);
        Color3f result(0.0f);
        if (its.mesh->isEmitter()) {
            const Emitter *seen = its.mesh->getEmitter();
            result = seen->eval(EmitterQueryRecord(seen, ray.o, its.p, its.shFrame.n, its.uv));
        }
        float emitterPdf = 0.0f;
        const Emitter *emitter = scene->sampleEmitter(sampler->next1D(), emitterPdf);
        EmitterQueryRecord lRec(its.p);
        const Point2f sample = sampler->next2D();
        const Color3f incident = emitter->sample(lRec, sample, sampler->next1D());
        if ((incident == 0.0f).all() ||
            scene->rayIntersect(Ray3f(its.p, lRec.wi, kMargin, lRec.dist - 1e-4f)))
            return result;
        const BSDFQueryRecord bRec(its.toLocal(-ray.d.normalized()), its.toLocal(lRec.wi), its.uv,
                                   ESolidAngle);
        const float cosTheta = std::max(0.0f, its.shFrame.n.dot(lRec.wi));
        return result + incident * its.mesh->getBSDF()->eval(bRec) * cosTheta / emitterPdf;
    }

    std::string toString() const override { return "WideMargin[]"; }
};

NORI_REGISTER_CLASS(WideMargin, "wide_margin")

NORI_NAMESPACE_END
