// SPDX-License-Identifier: MIT
#include <nori/camera.h>
#include <nori/integrator.h>
#include <nori/ray.h>
#include <nori/sampler.h>
#include <probe/probe.h>

#include <pcg32.h>

#include <stdexcept>
#include <thread>

namespace probe {

namespace {

std::uint64_t mix(std::uint64_t z) {
    // SplitMix64's finaliser: Steele, Lea, Flood 2014.
    z += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

/// Independent numbers for every ray. Stock Nori seeds by block position, so that all renders of a
/// scene share their noise.
class RaySampler : public nori::Sampler {
public:
    /// \param giveWay  lets another thread run before each number, in the middle of the integrator
    explicit RaySampler(bool giveWay = false) : m_giveWay(giveWay) { m_sampleCount = 1; }

    void startRay(std::uint64_t seed, std::uint64_t ray) {
        m_random.seed(mix(seed ^ mix(ray)), mix(ray ^ mix(seed)));
    }

    std::unique_ptr<nori::Sampler> clone() const override {
        return std::unique_ptr<nori::Sampler>(new RaySampler(*this));
    }

    void prepare(const nori::ImageBlock &) override {}

    void generate() override {}

    void advance() override {}

    float next1D() override {
        giveWay();
        return m_random.nextFloat();
    }

    nori::Point2f next2D() override {
        giveWay();
        // As constructor arguments, the compiler would choose the order.
        const float x = m_random.nextFloat();
        const float y = m_random.nextFloat();
        return nori::Point2f(x, y);
    }

    std::string toString() const override { return "RaySampler[]"; }

private:
    void giveWay() const {
        if (m_giveWay)
            std::this_thread::yield();
    }

    bool m_giveWay;
    pcg32 m_random;
};

const nori::Integrator *integratorOf(const nori::Scene &scene) {
    const nori::Integrator *integrator = scene.getIntegrator();
    if (integrator == nullptr)
        throw std::runtime_error("the scene has no integrator");
    return integrator;
}

/// What a scene's camera and integrator make of a point of the image.
class View {
public:
    explicit View(nori::Scene &scene)
        : m_scene(scene), m_integrator(integratorOf(scene)), m_camera(scene.getCamera()) {
        if (m_camera == nullptr)
            throw std::runtime_error("the scene has no camera");
    }

    int width() const { return m_camera->getOutputSize().x(); }

    /// \param point  in pixels
    nori::Color3f radiance(const nori::Point2f &point, nori::Sampler &sampler) const {
        const nori::Point2f aperture = sampler.next2D();
        nori::Ray3f ray;
        const nori::Color3f weight = m_camera->sampleRay(ray, point, aperture);
        return weight * m_integrator->Li(&m_scene, &sampler, ray);
    }

private:
    nori::Scene &m_scene;
    const nori::Integrator *m_integrator;
    const nori::Camera *m_camera;
};

} // namespace

Values answerRadiance(const protocol::Request &request, nori::Scene &scene) {
    const nori::Integrator *integrator = integratorOf(scene);
    RaySampler sampler;
    Values values;
    values.reserve(request.resultSize());
    const float *at = request.values.data();
    const float *end = at + request.values.size();
    for (std::uint64_t index = 0; at < end; ++index) {
        const auto origin = readVector<nori::Point3f>(at);
        const auto direction = readVector<nori::Vector3f>(at);
        const nori::Ray3f ray(origin, direction);
        sampler.startRay(request.seed, index);
        for (std::uint32_t i = 0; i < request.repeats; ++i)
            probe::append(values, integrator->Li(&scene, &sampler, ray));
    }
    return values;
}

Values answerImage(const protocol::Request &request, nori::Scene &scene) {
    const View view(scene);
    const int width = view.width();
    RaySampler sampler(request.index > 0);
    Values values;
    values.reserve(request.resultSize());
    for (const float value : request.values) {
        const int pixel = static_cast<int>(value);
        const int row = pixel / width;
        const nori::Point2f corner(static_cast<float>(pixel % width), static_cast<float>(row));
        sampler.startRay(request.seed, static_cast<std::uint64_t>(pixel));
        for (std::uint32_t i = 0; i < request.repeats; ++i) {
            const nori::Point2f within = sampler.next2D();
            probe::append(values, view.radiance(nori::Point2f(corner.x() + within.x(),
                                                              corner.y() + within.y()),
                                                sampler));
        }
    }
    return values;
}

Values answerFilm(const protocol::Request &request, nori::Scene &scene) {
    const View view(scene);
    RaySampler sampler;
    Values values;
    values.reserve(request.resultSize());
    for (std::size_t i = 0; i + 1 < request.values.size(); i += 2) {
        sampler.startRay(request.seed, i / 2);
        for (std::uint32_t k = 0; k < request.repeats; ++k)
            probe::append(
                values,
                view.radiance(nori::Point2f(request.values[i], request.values[i + 1]), sampler));
    }
    return values;
}

} // namespace probe
