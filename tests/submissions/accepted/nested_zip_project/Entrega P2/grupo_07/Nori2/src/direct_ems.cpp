#include <nori/Integrator.h>
#include <nori/scene.h>
#include <nori/emitter.h>
#include <nori/bsdf.h>
#include <nori/sampler.h>

NORI_NAMESPACE_BEGIN

class DirectEmitterSampling : public Integrator {
public:
	DirectEmitterSampling(const PropertyList &props) {}

	Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const {
		Intersection its;
		if (!scene->rayIntersect(ray, its))
			return scene->getBackground(ray);

		Color3f L(0.0f);
		if (its.mesh->isEmitter()) {
			EmitterQueryRecord q(its.mesh->getEmitter(), ray.o, its.p, its.shFrame.n, its.uv);
			L += its.mesh->getEmitter()->eval(q);
		}
		return L + direct(scene, sampler, ray, its);
	}

	std::string toString() const {
		return "DirectEmitterSampling[]";
	}

private:
	Color3f direct(const Scene *scene, Sampler *sampler, const Ray3f &ray, const Intersection &its) const {
		if (scene->getLights().empty())
			return Color3f(0.0f);

		float prob = 0;
		const Emitter *em = scene->sampleDirect(sampler->next1D(), prob);
		EmitterQueryRecord q(its.p);
		Color3f radiance = em->sample(q, sampler->next2D(), sampler->next1D());
		float pdf = em->pdf(q) * prob;
		if (pdf <= 0 || radiance.maxCoeff() <= 0)
			return Color3f(0.0f);

		if (!visible(scene, em, its.p, q))
			return Color3f(0.0f);

		BSDFQueryRecord b(its.toLocal(-ray.d), its.toLocal(q.wi), its.uv, ESolidAngle);
		float c = std::max(0.0f, its.shFrame.n.dot(q.wi));
		return radiance * its.mesh->getBSDF()->eval(b) * c / pdf;
	}

	bool visible(const Scene *scene, const Emitter *em, const Point3f &p, const EmitterQueryRecord &q) const {
		Intersection s;
		if (!scene->rayIntersect(Ray3f(p, q.wi), s))
			return true;
		// lo primero que hay en esa dirección es la propia luz
		if (s.mesh->isEmitter() && s.mesh->getEmitter() == em)
			return true;
		// luces puntuales: lo que haya detrás no hace sombra
		return em->isDelta() && s.t > q.dist;
	}
};

NORI_REGISTER_CLASS(DirectEmitterSampling, "direct_ems");
NORI_NAMESPACE_END
