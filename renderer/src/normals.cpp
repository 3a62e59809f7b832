// SPDX-License-Identifier: MIT
#include <nori/integrator.h>
#include <nori/scene.h>

NORI_NAMESPACE_BEGIN

/// Shows shading normals: the absolute values of their components as red, green and blue.
class NormalIntegrator : public Integrator {
public:
    NormalIntegrator(const PropertyList &) {}

    Color3f Li(const Scene *scene, Sampler *, const Ray3f &ray) const override {
        Intersection its;
        if (!scene->rayIntersect(ray, its))
            return Color3f(0.0f);
        return its.shFrame.n.cwiseAbs().array();
    }

    std::string toString() const override { return "NormalIntegrator[]"; }
};

NORI_REGISTER_CLASS(NormalIntegrator, "normals")

NORI_NAMESPACE_END
