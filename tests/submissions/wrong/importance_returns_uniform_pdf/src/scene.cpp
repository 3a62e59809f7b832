#include <nori/scene.h>
#include <nori/bitmap.h>
#include <nori/integrator.h>
#include <nori/sampler.h>
#include <nori/camera.h>
#include <nori/emitter.h>

NORI_NAMESPACE_BEGIN

Scene::Scene(const PropertyList &) {
    m_accel = new Accel();
    m_enviromentalEmitter = 0;
}

Scene::~Scene() {
    delete m_accel;
    delete m_sampler;
    delete m_camera;
    delete m_integrator;
}

void Scene::activate() {
    // Primero las luces de las mallas, que la distribución las tiene que conocer
    for (unsigned int i = 0; i < m_meshes.size(); ++i)
        if (m_meshes[i]->isEmitter())
            m_emitters.push_back(m_meshes[i]->getEmitter());

    m_accel->build();

    if (!m_integrator)
        throw NoriException("No integrator was specified!");
    if (!m_camera)
        throw NoriException("No camera was specified!");
    if (!m_sampler)
        m_sampler = static_cast<Sampler *>(
            NoriObjectFactory::createInstance("independent", PropertyList()));

    // EXTRA: probabilidad de cada luz proporcional a su luminancia
    m_emitterPDF.clear();
    for (auto e : m_emitters)
        m_emitterPDF.append(e->getLuminance());
    m_emitterPDF.normalize();
}

const Emitter *Scene::sampleEmitter(float rnd, float &pdf) const {
    if (m_emitterPDF.isNormalized())
    {
        pdf = 1.f / m_emitters.size();
        return m_emitters[m_emitterPDF.sample(rnd)];
    }

    // todas negras: uniforme, como estaba
    auto const &n = m_emitters.size();
    size_t index = std::min(static_cast<size_t>(std::floor(n * rnd)), n - 1);
    pdf = 1.f / float(n);
    return m_emitters[index];
}

float Scene::pdfEmitter(const Emitter *em) const {
    if (!m_emitterPDF.isNormalized())
        return 1.f / float(m_emitters.size());
    for (size_t i = 0; i < m_emitters.size(); i++)
        if (m_emitters[i] == em)
            return m_emitterPDF[i];
    return 0.f;
}

Color3f Scene::getBackground(const Ray3f &ray) const {
    if (!m_enviromentalEmitter)
        return Color3f(0.f);
    EmitterQueryRecord lRec(m_enviromentalEmitter, ray.o, ray.o + ray.d, Normal3f(0, 0, 1), Vector2f());
    return m_enviromentalEmitter->eval(lRec);
}

void Scene::addChild(NoriObject *obj, const std::string &name) {
    switch (obj->getClassType()) {
        case EMesh: {
                Mesh *mesh = static_cast<Mesh *>(obj);
                m_accel->addMesh(mesh);
                m_meshes.push_back(mesh);
            }
            break;

        case EEmitter: {
                Emitter *emitter = static_cast<Emitter *>(obj);
                if (emitter->getEmitterType() == EmitterType::EMITTER_ENVIRONMENT) {
                    if (m_enviromentalEmitter)
                        throw NoriException("There can only be one environment emitter per scene!");
                    m_enviromentalEmitter = emitter;
                }
                m_emitters.push_back(emitter);
            }
            break;

        case ESampler:
            if (m_sampler)
                throw NoriException("There can only be one sampler per scene!");
            m_sampler = static_cast<Sampler *>(obj);
            break;

        case ECamera:
            if (m_camera)
                throw NoriException("There can only be one camera per scene!");
            m_camera = static_cast<Camera *>(obj);
            break;

        case EIntegrator:
            if (m_integrator)
                throw NoriException("There can only be one integrator per scene!");
            m_integrator = static_cast<Integrator *>(obj);
            break;

        default:
            throw NoriException("Scene::addChild(<%s>) is not supported!",
                                classTypeName(obj->getClassType()));
    }
}

std::string Scene::toString() const {
    std::string meshes, lights;
    for (auto m : m_meshes)
        meshes += "\n    " + indent(m->toString(), 4) + ",";
    for (auto l : m_emitters)
        lights += "\n    " + indent(l->toString(), 4) + ",";
    return tfm::format(
        "Scene[\n"
        "  integrator = %s,\n"
        "  sampler = %s\n"
        "  camera = %s,\n"
        "  meshes = {%s\n  }\n"
        "  emitters = {%s\n  }\n"
        "]",
        indent(m_integrator->toString()), indent(m_sampler->toString()),
        indent(m_camera->toString()), meshes, lights);
}

NORI_REGISTER_CLASS(Scene, "scene");
NORI_NAMESPACE_END
