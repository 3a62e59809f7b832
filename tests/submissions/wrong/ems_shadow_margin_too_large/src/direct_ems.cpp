#include <nori/integrator.h>
#include <nori/scene.h>
#include <nori/emitter.h>
#include <nori/bsdf.h>
#include <nori/sampler.h>

NORI_NAMESPACE_BEGIN

/*
 * Iluminación directa muestreando UNA luz al azar por muestra (ec. 9 del guion).
 */
class DirectEmitterSampling : public Integrator {
public:
    DirectEmitterSampling(const PropertyList &props) { }

    Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const {
        Intersection its;
        if (!scene->rayIntersect(ray, its))
            return scene->getBackground(ray);

        Color3f Le(0.f), Lr(0.f);

        // 1. Luz que vemos directamente
        if (its.mesh->isEmitter()) {
            const Emitter *luz = its.mesh->getEmitter();
            EmitterQueryRecord vista(luz, ray.o, its.p, its.shFrame.n, its.uv);
            Le = luz->eval(vista);
        }

        // 2. Luz reflejada
        if (scene->getLights().empty())
            return Le;

        float pdfElegir;
        const Emitter *em = scene->sampleEmitter(sampler->next1D(), pdfElegir);
        if (pdfElegir <= 0)
            return Le;

        EmitterQueryRecord lRec(its.p);
        Color3f Li = em->sample(lRec, sampler->next2D(), sampler->next1D()); // ya dividido por la pdf
        if (Li.isZero())
            return Le;

        // Rayo de sombra, sin llegar a tocar la luz
        float margen = std::max(1e-3f, lRec.dist * 1e-4f);
        Ray3f sombra(its.p, lRec.wi, 0.3f, lRec.dist * 0.8f); // evita el acné
        if (!scene->rayIntersect(sombra)) {
            Vector3f wo = its.toLocal(-ray.d.normalized());
            Vector3f wi = its.toLocal(lRec.wi);
            BSDFQueryRecord bRec(wo, wi, its.uv, ESolidAngle);
            float coseno = std::max(0.f, Frame::cosTheta(wi));
            Lr = Li * its.mesh->getBSDF()->eval(bRec) * coseno / pdfElegir;
        }
        return Le + Lr;
    }

    std::string toString() const {
        return "DirectEmitterSampling[]";
    }
};

NORI_REGISTER_CLASS(DirectEmitterSampling, "direct_ems");
NORI_NAMESPACE_END
