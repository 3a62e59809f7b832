// SPDX-License-Identifier: MIT
#pragma once

#include <nori/mesh.h>
#include <nori/object.h>

#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace nori::test {

constexpr double kPi = 3.14159265358979323846;

/// A mesh from tables.
class TestMesh : public Mesh {
public:
    TestMesh(const std::vector<Point3f> &vertices, const std::vector<Vector3i> &faces) {
        m_name = "test";
        m_V.resize(3, static_cast<Eigen::Index>(vertices.size()));
        for (size_t i = 0; i < vertices.size(); ++i) {
            m_V.col(static_cast<Eigen::Index>(i)) = vertices[i];
            m_bbox.expandBy(vertices[i]);
        }
        m_F.resize(3, static_cast<Eigen::Index>(faces.size()));
        for (size_t i = 0; i < faces.size(); ++i)
            m_F.col(static_cast<Eigen::Index>(i)) = faces[i].cast<uint32_t>();
    }

    void setNormals(const MatrixXf &normals) { m_N = normals; }

    void setTexCoords(const MatrixXf &uv) { m_UV = uv; }
};

/// The square [-1, 1]^2 at height `z` of two triangles, seen from above if `up`; uv = (x, y).
inline std::unique_ptr<TestMesh> makeSquare(float z, bool up) {
    const std::vector<Point3f> vertices{{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    auto mesh =
        up ? std::make_unique<TestMesh>(vertices, std::vector<Vector3i>{{0, 1, 2}, {0, 2, 3}})
           : std::make_unique<TestMesh>(vertices, std::vector<Vector3i>{{0, 2, 1}, {0, 3, 2}});
    MatrixXf uv(2, 4);
    uv << -1, 1, 1, -1, -1, -1, 1, 1;
    mesh->setTexCoords(uv);
    return mesh;
}

/// An activated plugin.
template <typename T>
std::unique_ptr<T> make(const std::string &type, const PropertyList &props = PropertyList()) {
    std::unique_ptr<T> object(static_cast<T *>(NoriObjectFactory::createInstance(type, props)));
    object->activate();
    return object;
}

/// A folder that is removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "nori-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw NoriException("mkdtemp() failed");
        m_path = name;
    }

    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }

    TemporaryFolder(TemporaryFolder &&) = delete;
    TemporaryFolder &operator=(TemporaryFolder &&) = delete;
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    std::string file(const std::string &name) const { return (m_path / name).string(); }

private:
    std::filesystem::path m_path;
};

/// Centres of an n x n grid over the unit square, in place of random numbers.
inline std::vector<Point2f> squareGrid(int n) {
    std::vector<Point2f> points;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j)
            points.emplace_back((static_cast<float>(j) + 0.5f) / static_cast<float>(n),
                                (static_cast<float>(i) + 0.5f) / static_cast<float>(n));
    }
    return points;
}

/// Inputs that warps get wrong: both ends of [0, 1) and the smallest step of the sampler.
inline std::vector<Point2f> edgeInputs() {
    const float values[] = {0.0f, 1e-38f, 0x1p-23f, 0.5f, 1.0f - 0x1p-23f, 1.0f - 0x1p-24f};
    std::vector<Point2f> points;
    for (const float x : values) {
        for (const float y : values)
            points.emplace_back(x, y);
    }
    return points;
}

} // namespace nori::test
