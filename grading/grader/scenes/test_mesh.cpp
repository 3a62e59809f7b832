// SPDX-License-Identifier: MIT
#include "test_mesh.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

namespace grader {

using std::numbers::pi;

double SceneRandom::uniform(double low, double high) {
    return low + (high - low) * nextDouble();
}

Vector3d SceneRandom::direction() {
    const double z = uniform(-1, 1);
    const double phi = uniform(0, 2 * pi);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

Vector3d SceneRandom::color(double low, double high) {
    const double r = uniform(low, high);
    const double g = uniform(low, high);
    const double b = uniform(low, high);
    return {r, g, b};
}

Eigen::Isometry3d SceneRandom::rigid(double reach) {
    // A uniform unit quaternion is a uniform rotation: Shoemake 1992.
    const double u = uniform();
    const double v = uniform(0, 2 * pi);
    const double w = uniform(0, 2 * pi);
    Eigen::Isometry3d transform(
        Eigen::Quaterniond(std::sqrt(1 - u) * std::sin(v), std::sqrt(1 - u) * std::cos(v),
                           std::sqrt(u) * std::sin(w), std::sqrt(u) * std::cos(w)));
    transform.pretranslate(color(-reach, reach));
    return transform;
}

double TestMesh::area(std::size_t face) const {
    const auto &[a, b, c] = faces[face];
    return 0.5 * (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm();
}

double TestMesh::area() const {
    double sum = 0;
    for (std::size_t face = 0; face < faces.size(); ++face)
        sum += area(face);
    return sum;
}

Vector3d TestMesh::geometricNormal(std::size_t face) const {
    const auto &[a, b, c] = faces[face];
    return (positions[b] - positions[a]).cross(positions[c] - positions[a]).normalized();
}

TestMesh TestMesh::transformed(const Eigen::Isometry3d &transform) const {
    const auto round = [](const auto &v) {
        return v.template cast<float>().template cast<double>();
    };
    TestMesh moved = *this;
    for (Vector3d &p : moved.positions)
        p = round((transform * p).eval()).eval();
    for (Vector3d &n : moved.normals)
        n = round((transform.linear() * n).eval()).eval();
    for (Vector2d &t : moved.uvs)
        t = round(t).eval();
    return moved;
}

std::string TestMesh::toObj() const {
    std::string text;
    for (const Vector3d &p : positions)
        text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
    for (const Vector2d &t : uvs)
        text += fmt::format("vt {:.9g} {:.9g}\n", t.x(), t.y());
    for (const Vector3d &n : normals)
        text += fmt::format("vn {:.9g} {:.9g} {:.9g}\n", n.x(), n.y(), n.z());
    for (const auto &face : faces) {
        text += "f";
        for (const int vertex : face) {
            const int i = vertex + 1;
            if (!uvs.empty() && !normals.empty())
                text += fmt::format(" {0}/{0}/{0}", i);
            else if (!uvs.empty())
                text += fmt::format(" {0}/{0}", i);
            else if (!normals.empty())
                text += fmt::format(" {0}//{0}", i);
            else
                text += fmt::format(" {}", i);
        }
        text += "\n";
    }
    return text;
}

TestMesh parallelogram(const Vector3d &corner, const Vector3d &a, const Vector3d &b) {
    TestMesh mesh;
    mesh.positions = {corner, corner + a, corner + a + b, corner + b};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.faces = {{0, 1, 2}, {2, 3, 0}};
    return mesh;
}

TestMesh patch(const Vector3d &corner, const Vector3d &a, const Vector3d &b, int pieces,
               SceneRandom &random) {
    std::array<std::vector<double>, 2> cuts;
    for (std::vector<double> &positions : cuts) {
        for (int i = 0; i <= pieces; ++i) {
            const bool inside = i > 0 && i < pieces;
            positions.push_back((i + (inside ? random.uniform(-0.35, 0.35) : 0)) / pieces);
        }
    }
    TestMesh mesh;
    for (const double t : cuts[1]) {
        for (const double s : cuts[0]) {
            mesh.positions.emplace_back(corner + s * a + t * b);
            mesh.uvs.emplace_back(s, t);
        }
    }
    for (int j = 0; j < pieces; ++j) {
        for (int i = 0; i < pieces; ++i) {
            const int first = j * (pieces + 1) + i;
            const int above = first + pieces + 1;
            mesh.faces.push_back({first, first + 1, above + 1});
            mesh.faces.push_back({above + 1, above, first});
        }
    }
    return mesh;
}

TestMesh block(const Vector3d &center, const Vector3d &size, double turn) {
    const Eigen::AngleAxisd rotation(turn, Vector3d::UnitZ());
    TestMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-0.5, 0.5}) {
            Vector3d a = Vector3d::Zero();
            Vector3d b = Vector3d::Zero();
            Vector3d out = Vector3d::Zero();
            a[(axis + 1) % 3] = size[(axis + 1) % 3];
            b[(axis + 2) % 3] = size[(axis + 2) % 3];
            out[axis] = side * size[axis];
            if (side < 0)
                a.swap(b);
            const TestMesh face = parallelogram(out - 0.5 * a - 0.5 * b, a, b);
            const int first = static_cast<int>(mesh.positions.size());
            for (const Vector3d &p : face.positions)
                mesh.positions.emplace_back(center + rotation * p);
            mesh.uvs.insert(mesh.uvs.end(), face.uvs.begin(), face.uvs.end());
            for (const auto &[i, j, k] : face.faces)
                mesh.faces.push_back({first + i, first + j, first + k});
        }
    }
    return mesh;
}

TestMesh sphere(const Vector3d &center, double radius, int stacks) {
    TestMesh mesh;
    const int slices = 2 * stacks;
    for (int i = 0; i <= stacks; ++i) {
        for (int j = 0; j <= slices; ++j) {
            const double theta = pi * i / stacks;
            const double phi = 2 * pi * j / slices;
            const Vector3d n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta));
            mesh.positions.emplace_back(center + radius * n);
            mesh.normals.push_back(n);
            mesh.uvs.emplace_back(static_cast<double>(j) / slices, static_cast<double>(i) / stacks);
        }
    }
    for (int i = 0; i < stacks; ++i) {
        for (int j = 0; j < slices; ++j) {
            const int a = i * (slices + 1) + j;
            const int b = a + slices + 1;
            if (i > 0)
                mesh.faces.push_back({a, b, a + 1});
            if (i < stacks - 1)
                mesh.faces.push_back({a + 1, b, b + 1});
        }
    }
    return mesh;
}

TestMesh unequalStrip(SceneRandom &random) {
    TestMesh mesh;
    double along = 0;
    for (int i = 0; i < 6; ++i) {
        const double width = 0.15 + 0.3 * i + random.uniform(0, 0.1);
        mesh.positions.emplace_back(along, 0, 0.1 * i * i);
        mesh.positions.emplace_back(along + 0.1, width, 0.1 * i * i - 0.2);
        along += 0.1 + 0.2 * i + random.uniform(0, 0.05);
    }
    for (int i = 0; i + 2 < static_cast<int>(mesh.positions.size()); ++i) {
        const int second = i % 2 == 0 ? i + 2 : i + 1;
        mesh.faces.push_back({i, second, 2 * i + 3 - second});
    }
    return mesh;
}

double polygonIrradiance(const Vector3d &point, const Vector3d &normal,
                         const std::vector<Vector3d> &polygon) {
    std::vector<Vector3d> clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3d a = polygon[i] - point;
        const Vector3d b = polygon[(i + 1) % polygon.size()] - point;
        const double heightA = a.dot(normal);
        const double heightB = b.dot(normal);
        if (heightA >= 0)
            clipped.push_back(a);
        if ((heightA > 0 && heightB < 0) || (heightA < 0 && heightB > 0))
            clipped.emplace_back(a + (b - a) * (heightA / (heightA - heightB)));
    }
    double sum = 0;
    for (std::size_t i = 0; i < clipped.size(); ++i) {
        const Vector3d &a = clipped[i];
        const Vector3d &b = clipped[(i + 1) % clipped.size()];
        const Vector3d cross = a.cross(b);
        if (cross.norm() > 0)
            sum += std::atan2(cross.norm(), a.dot(b)) * cross.normalized().dot(normal);
    }
    return std::abs(sum) / 2;
}

} // namespace grader
