// SPDX-License-Identifier: MIT
#pragma once

#include <grader/scenes/test_mesh.h>
#include <protocol/request.h>

#include <optional>
#include <string>
#include <vector>

namespace grader {

/// What an area light is besides its mesh.
struct Emission {
    Vector3d radiance{1, 1, 1};
    std::optional<double> scale; ///< the `scale` property
    std::optional<std::string>
        texture; ///< XML of a texture named `radiance`, instead of `radiance`
};

/// Builds a Nori scene in memory: the XML and the OBJ files that a probe is sent. Emitters stand in
/// Scene::getLights() in this order: point lights and the environment as added, then area lights.
class TestScene {
public:
    explicit TestScene(std::string integrator = "direct_ems");

    /// A diffuse mesh. \return  its index in Scene::getMeshes()
    int addMesh(const TestMesh &mesh, const Vector3d &albedo);
    int addLight(const TestMesh &mesh, const Vector3d &albedo, const Emission &emission);
    void addPointLight(const Vector3d &position, const Vector3d &intensity);

    /// \param mapFile  name of a file that addFile() was given, or empty for a constant one
    void addEnvironment(const Vector3d &radiance, const std::string &mapFile = "");
    void addFile(const std::string &name, const std::string &bytes);

    /// What Request::text is for requests on this scene.
    static constexpr char kFileName[] = "scene.xml";

    /// All files of the scene, XML first.
    std::vector<protocol::File> files() const;

private:
    int addObject(const TestMesh &mesh, const Vector3d &albedo, const std::string &emitterXml);

    std::string m_integrator;
    std::string m_objects;
    std::vector<protocol::File> m_files;
    int m_meshCount = 0;
};

} // namespace grader
