// SPDX-License-Identifier: MIT
#include <nori/bitmap.h>
#include <nori/bsdf.h>
#include <nori/emitter.h>

#include <unistd.h>

#include <filesystem>
#include <memory>

#include <bindings/sampler_bindings.h>

namespace bindings {

namespace {

using battery::Input;
using battery::Output;

template <typename T>
std::shared_ptr<const T> make(const std::string &type, const nori::PropertyList &properties = {}) {
    std::shared_ptr<T> object(
        static_cast<T *>(nori::NoriObjectFactory::createInstance(type, properties)));
    object->activate();
    return object;
}

Output toOutput(const nori::Vector3f &v) {
    return {v.x(), v.y(), v.z()};
}

nori::Bitmap smallMap() {
    constexpr int kRows = 8;
    constexpr int kColumns = 16;
    nori::Bitmap map(nori::Vector2i(kColumns, kRows));
    for (int row = 0; row < kRows; ++row) {
        for (int column = kColumns / 2; column < kColumns; ++column) {
            map.coeffRef(row, column) = nori::Color3f(0.1F * static_cast<float>(row + 1));
        }
    }
    map.coeffRef(2, 12) = nori::Color3f(50.0F, 40.0F, 30.0F);
    return map;
}

/// A file that is there while it is read.
class TemporaryMap {
public:
    explicit TemporaryMap(const nori::Bitmap &map)
        : m_stem((std::filesystem::temp_directory_path() /
                  ("warptest-map-" + std::to_string(::getpid())))
                     .string()) {
        map.saveEXR(m_stem);
    }

    ~TemporaryMap() {
        std::error_code ignored;
        std::filesystem::remove(path(), ignored);
    }

    TemporaryMap(const TemporaryMap &) = delete;
    TemporaryMap &operator=(const TemporaryMap &) = delete;
    TemporaryMap(TemporaryMap &&) = delete;
    TemporaryMap &operator=(TemporaryMap &&) = delete;

    [[nodiscard]] std::string path() const { return m_stem + ".exr"; }

private:
    std::string m_stem;
};

} // namespace

Sampler environmentSampler(const std::string &map) {
    nori::PropertyList properties;
    properties.setString("filename", map);
    properties.setString("sampling", "map");
    const auto emitter = make<nori::Emitter>("environment", properties);
    const nori::Bitmap image(map);
    return {
        "environment",
        catalog::latitudeLongitude(static_cast<int>(image.rows()), static_cast<int>(image.cols())),
        [emitter](const Input &s) {
            nori::EmitterQueryRecord record(nori::Point3f(0.0F));
            emitter->sample(record, nori::Point2f(s.u, s.v), 0.5F);
            return toOutput(record.wi);
        },
        [emitter](const Output &p) {
            nori::EmitterQueryRecord record;
            record.wi = nori::Vector3f(p.x, p.y, p.z);
            return emitter->pdf(record);
        }};
}

Sampler environmentSampler() {
    const TemporaryMap map(smallMap());
    return environmentSampler(map.path());
}

Sampler diffuseSampler() {
    const auto bsdf = make<nori::BSDF>("diffuse");
    const nori::Vector3f wi = nori::Vector3f(0.3F, -0.5F, 0.7F).normalized();
    return {"diffuse", catalog::zone(0.0, 1.0),
            [bsdf, wi](const Input &s) {
                nori::BSDFQueryRecord record(wi);
                bsdf->sample(record, nori::Point2f(s.u, s.v));
                return toOutput(record.wo);
            },
            [bsdf, wi](const Output &p) {
                const nori::BSDFQueryRecord record(wi, nori::Vector3f(p.x, p.y, p.z),
                                                   nori::Vector2f(0.0F), nori::ESolidAngle);
                return bsdf->pdf(record);
            }};
}

} // namespace bindings
