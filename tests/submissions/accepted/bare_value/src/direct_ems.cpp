#include <nori/integrator.h>
#include <nori/scene.h>
#include <nori/sampler.h>
#include <nori/emitter.h>
#include <nori/bsdf.h>

NORI_NAMESPACE_BEGIN

class DirectEmitterSampling : public Integrator {
public:
    DirectEmitterSampling(const PropertyList &props) {
        /* Sin parámetros */
    }

    Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const {
        Color3f color(0.);

        Intersection its;
        if (!scene->rayIntersect(ray, its))
            return scene->getBackground(ray);

        // Emisores visibles
        if (its.mesh->isEmitter()) {
            EmitterQueryRecord visible(its.mesh->getEmitter(), ray.o, its.p, its.shFrame.n, its.uv);
            color += its.mesh->getEmitter()->eval(visible);
        }

        if (scene->getLights().size() == 0)
            return color;

        float pdfLuz = 0.f;
        const Emitter *luz = scene->sampleEmitter(sampler->next1D(), pdfLuz);

        EmitterQueryRecord lRec;
        lRec.ref = its.p;
        Color3f Le = luz->sample(lRec, sampler->next2D(), 0.f);
        if (lRec.pdf == 0.f || pdfLuz == 0.f)
            return color;

        // Visibilidad: si lo primero que encontramos está antes que la luz, hay sombra
        Intersection sombra;
        Ray3f rayoSombra(its.p, lRec.wi);
        if (scene->rayIntersect(rayoSombra, sombra) && sombra.t < lRec.dist * (1.f - 1e-3f))
            return color;

        BSDFQueryRecord bRec(its.toLocal(-ray.d).normalized(), its.toLocal(lRec.wi), its.uv, ESolidAngle);
        float cosTheta = its.shFrame.n.dot(lRec.wi);
        if (cosTheta <= 0.f)
            return color;

        color += Le * its.mesh->getBSDF()->eval(bRec) * cosTheta / (lRec.pdf * pdfLuz);
        return color;
    }

    std::string toString() const {
        return "Direct Emitter Sampling []";
    }
};

NORI_REGISTER_CLASS(DirectEmitterSampling, "direct_ems");
NORI_NAMESPACE_END
