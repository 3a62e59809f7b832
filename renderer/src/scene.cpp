// SPDX-License-Identifier: MIT
#include <nori/camera.h>
#include <nori/integrator.h>
#include <nori/sampler.h>
#include <nori/scene.h>

#include <algorithm>

NORI_NAMESPACE_BEGIN

Scene::Scene(const PropertyList &props) {
    (void)props;
    // graded: begin
    const std::string choice = props.getString("emitterSampling", "uniform");
    if (choice != "uniform" && choice != "power")
        throw NoriException("Property 'emitterSampling' is \"%s\"; known: uniform, power", choice);
    m_sampleByPower = choice == "power";
    // graded: end
    m_accel = new Accel();
}

Scene::~Scene() {
    for (Emitter *emitter : m_emitters) {
        const bool ownedByMesh =
            std::any_of(m_meshes.begin(), m_meshes.end(),
                        [emitter](Mesh *mesh) { return mesh->getEmitter() == emitter; });
        if (!ownedByMesh)
            delete emitter;
    }
    delete m_accel; // and the meshes
    delete m_sampler;
    delete m_camera;
    delete m_integrator;
}

void Scene::activate() {
    for (Mesh *mesh : m_meshes) {
        if (mesh->isEmitter())
            m_emitters.push_back(mesh->getEmitter());
    }
    m_accel->build();

    if (m_integrator == nullptr)
        throw NoriException("No integrator was specified!");
    if (m_camera == nullptr)
        throw NoriException("No camera was specified!");
    if (m_sampler == nullptr) {
        m_sampler = static_cast<Sampler *>(
            NoriObjectFactory::createInstance("independent", PropertyList()));
        m_sampler->activate();
    }
    // graded: begin

    if (m_sampleByPower && !m_emitters.empty()) {
        const BoundingBox3f &bbox = getBoundingBox();
        const float radius = bbox.isValid() ? 0.5f * bbox.getExtents().norm() : 1.0f;
        for (const Emitter *emitter : m_emitters) {
            const bool infinite = emitter->getEmitterType() == EmitterType::EMITTER_ENVIRONMENT;
            const float power = emitter->power().getLuminance();
            m_emitterPdf.append(std::max(0.0f, infinite ? radius * radius * power : power));
        }
        if (!std::isfinite(m_emitterPdf.normalize()))
            throw NoriException("The power of the scene's emitters is not finite!");
    }
    // graded: end
}

const Emitter *Scene::sampleEmitter(float rnd, float &pdf) const {
    if (m_emitters.empty())
        throw NoriException("Scene::sampleEmitter(): the scene has no emitter!");
    // graded: begin
    if (m_emitterPdf.isNormalized()) {
        // 0 would be given to the first emitter even if that has no power
        const float u = std::max(rnd, std::numeric_limits<float>::min());
        return m_emitters[m_emitterPdf.sample(u, pdf)];
    }
    // graded: end
    const size_t count = m_emitters.size();
    const auto index = static_cast<size_t>(std::floor(static_cast<float>(count) * rnd));
    pdf = 1.0f / static_cast<float>(count);
    return m_emitters[std::min(index, count - 1)];
}

float Scene::pdfEmitter(const Emitter *em) const {
    if (m_emitters.empty())
        throw NoriException("Scene::pdfEmitter(): the scene has no emitter!");
    (void)em; // all alike
    // graded: begin
    if (m_emitterPdf.isNormalized()) {
        const auto it = std::find(m_emitters.begin(), m_emitters.end(), em);
        return it == m_emitters.end() ? 0.0f
                                      : m_emitterPdf[static_cast<size_t>(it - m_emitters.begin())];
    }
    // graded: end
    return 1.0f / static_cast<float>(m_emitters.size());
}

Color3f Scene::getBackground(const Ray3f &ray) const {
    if (m_enviromentalEmitter == nullptr)
        return Color3f(0.0f);
    const EmitterQueryRecord lRec(m_enviromentalEmitter, ray.o, ray.o + ray.d,
                                  Normal3f(0.0f, 0.0f, 1.0f), Point2f(0.0f));
    return m_enviromentalEmitter->eval(lRec);
}

void Scene::addChild(NoriObject *obj, const std::string &) {
    switch (obj->getClassType()) {
    case EMesh: {
        auto *mesh = static_cast<Mesh *>(obj);
        m_accel->addMesh(mesh);
        m_meshes.push_back(mesh);
        break;
    }
    case EEmitter: {
        auto *emitter = static_cast<Emitter *>(obj);
        if (emitter->getEmitterType() == EmitterType::EMITTER_ENVIRONMENT) {
            if (m_enviromentalEmitter != nullptr)
                throw NoriException("There can only be one environment emitter per scene!");
            m_enviromentalEmitter = emitter;
        }
        m_emitters.push_back(emitter);
        break;
    }
    case ESampler:
        if (m_sampler != nullptr)
            throw NoriException("There can only be one sampler per scene!");
        m_sampler = static_cast<Sampler *>(obj);
        break;
    case ECamera:
        if (m_camera != nullptr)
            throw NoriException("There can only be one camera per scene!");
        m_camera = static_cast<Camera *>(obj);
        break;
    case EIntegrator:
        if (m_integrator != nullptr)
            throw NoriException("There can only be one integrator per scene!");
        m_integrator = static_cast<Integrator *>(obj);
        break;
    default:
        throw NoriException("Scene::addChild(<%s>) is not supported!",
                            classTypeName(obj->getClassType()));
    }
}

std::string Scene::toString() const {
    const auto describe = [](const NoriObject *object) {
        return object != nullptr ? indent(object->toString()) : std::string("null");
    };
    const auto describeAll = [](const auto &objects) {
        std::string result;
        for (const auto *object : objects)
            result += (result.empty() ? "\n    " : ",\n    ") + indent(object->toString(), 4);
        return result + "\n  ";
    };
    return tfm::format("Scene[\n"
                       "  integrator = %s,\n"
                       "  sampler = %s,\n"
                       "  camera = %s,\n"
                       "  meshes = {%s},\n"
                       "  emitters = {%s}\n"
                       "]",
                       describe(m_integrator), describe(m_sampler), describe(m_camera),
                       describeAll(m_meshes), describeAll(m_emitters));
}

NORI_REGISTER_CLASS(Scene, "scene")

NORI_NAMESPACE_END
