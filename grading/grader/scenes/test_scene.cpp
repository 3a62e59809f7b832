// SPDX-License-Identifier: MIT
#include "test_scene.h"

#include <fmt/core.h>

namespace grader {

namespace {

std::string triple(const Vector3d &v) {
    return fmt::format("{:.9g}, {:.9g}, {:.9g}", v.x(), v.y(), v.z());
}

/// The camera and sampler that Scene::activate() asks for; the probe uses neither.
constexpr char kUnused[] =
    R"(  <sampler type="independent"><integer name="sampleCount" value="1"/></sampler>
  <camera type="perspective"><integer name="width" value="8"/><integer name="height" value="8"/></camera>
)";

} // namespace

TestScene::TestScene(std::string integrator) : m_integrator(std::move(integrator)) {}

int TestScene::addObject(const TestMesh &mesh, const Vector3d &albedo,
                         const std::string &emitterXml) {
    const std::string name = fmt::format("mesh{}.obj", m_meshCount);
    m_files.push_back({name, mesh.toObj()});
    m_objects += fmt::format(R"(  <mesh type="obj"><string name="filename" value="{}"/>
    <bsdf type="diffuse"><color name="albedo" value="{}"/></bsdf>{}</mesh>
)",
                             name, triple(albedo), emitterXml);
    return m_meshCount++;
}

int TestScene::addMesh(const TestMesh &mesh, const Vector3d &albedo) {
    return addObject(mesh, albedo, "");
}

int TestScene::addLight(const TestMesh &mesh, const Vector3d &albedo, const Emission &emission) {
    std::string xml = "\n    <emitter type=\"area\">";
    xml += emission.texture
               ? *emission.texture
               : fmt::format(R"(<color name="radiance" value="{}"/>)", triple(emission.radiance));
    if (emission.scale)
        xml += fmt::format(R"(<float name="scale" value="{:.9g}"/>)", *emission.scale);
    return addObject(mesh, albedo, xml + "</emitter>");
}

void TestScene::addPointLight(const Vector3d &position, const Vector3d &intensity) {
    m_objects += fmt::format(
        R"(  <emitter type="pointlight"><point name="position" value="{}"/><color name="radiance" value="{}"/></emitter>
)",
        triple(position), triple(intensity));
}

void TestScene::addEnvironment(const Vector3d &radiance, const std::string &mapFile) {
    const std::string file =
        mapFile.empty() ? "" : fmt::format(R"(<string name="filename" value="{}"/>)", mapFile);
    m_objects += fmt::format(
        R"(  <emitter type="environment">{}<color name="radiance" value="{}"/></emitter>
)",
        file, triple(radiance));
}

void TestScene::addFile(const std::string &name, const std::string &bytes) {
    m_files.push_back({name, bytes});
}

std::vector<protocol::File> TestScene::files() const {
    std::vector<protocol::File> files = {
        {kFileName, fmt::format("<scene>\n  <integrator type=\"{}\"/>\n{}{}</scene>\n",
                                m_integrator, kUnused, m_objects)}};
    files.insert(files.end(), m_files.begin(), m_files.end());
    return files;
}

} // namespace grader
