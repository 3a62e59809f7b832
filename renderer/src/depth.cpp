// SPDX-License-Identifier: MIT
#include <nori/integrator.h>
#include <nori/scene.h>

NORI_NAMESPACE_BEGIN

/// Shows the reciprocal of the distance to what a ray hits; black for nothing.
class DepthIntegrator : public Integrator {
public:
    DepthIntegrator(const PropertyList &) {}

    Color3f Li(const Scene *scene, Sampler *, const Ray3f &ray) const override {
        Intersection its;
        if (!scene->rayIntersect(ray, its))
            return Color3f(0.0f);
        return Color3f(1.0f / (its.t * ray.d.norm()));
    }

    std::string toString() const override { return "DepthIntegrator[]"; }
};

NORI_REGISTER_CLASS(DepthIntegrator, "depth")

NORI_NAMESPACE_END
