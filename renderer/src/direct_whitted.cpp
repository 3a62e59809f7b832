// SPDX-License-Identifier: MIT
#include <nori/bsdf.h>
#include <nori/emitter.h>
#include <nori/integrator.h>
#include <nori/sampler.h>
#include <nori/scene.h>

NORI_NAMESPACE_BEGIN

/// Direct light from every emitter of the scene; emitters themselves are not visible.
class DirectWhittedIntegrator : public Integrator {
public:
    DirectWhittedIntegrator(const PropertyList &) {}

    Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const override {
        Intersection its;
        if (!scene->rayIntersect(ray, its))
            return scene->getBackground(ray);

        const Vector3f wi = its.toLocal(-ray.d.normalized());
        Color3f result(0.0f);
        for (const Emitter *emitter : scene->getLights()) {
            EmitterQueryRecord lRec(its.p);
            const Point2f sample = sampler->next2D();
            const Color3f incident = emitter->sample(lRec, sample, sampler->next1D());
            if ((incident == 0.0f).all())
                continue;

            const float slack = Epsilon * std::max(1.0f, lRec.p.cwiseAbs().maxCoeff());
            if (scene->rayIntersect(Ray3f(its.p, lRec.wi, Epsilon, lRec.dist - slack)))
                continue;

            const BSDFQueryRecord bRec(wi, its.toLocal(lRec.wi), its.uv, ESolidAngle);
            const float cosTheta = std::max(0.0f, its.shFrame.n.dot(lRec.wi));
            result += incident * its.mesh->getBSDF()->eval(bRec) * cosTheta;
        }
        return result;
    }

    std::string toString() const override { return "DirectWhittedIntegrator[]"; }
};

NORI_REGISTER_CLASS(DirectWhittedIntegrator, "direct_whitted")

NORI_NAMESPACE_END
