// SPDX-License-Identifier: MIT
#include "mesh_samples.h"

#include <grader/checks/answer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace grader {

namespace {

const Vector3d &vertex(const TestMesh &mesh, std::size_t face, std::size_t corner) {
    return mesh.positions[static_cast<std::size_t>(mesh.faces[face][corner])];
}

/// Nearest point of a triangle, as barycentric weights. \see Ericson 2005, 5.1.5; here by clamping
/// the plane projection, which is exact for the points near the triangle that matter.
Vector3d nearestWeights(const TestMesh &mesh, std::size_t face, const Vector3d &p) {
    const Vector3d &a = vertex(mesh, face, 0);
    const Vector3d ab = vertex(mesh, face, 1) - a;
    const Vector3d ac = vertex(mesh, face, 2) - a;
    const Vector3d n = ab.cross(ac);
    const double area2 = n.squaredNorm();
    const double beta = (p - a).cross(ac).dot(n) / area2;
    const double gamma = ab.cross(p - a).dot(n) / area2;
    Vector3d weights(1 - beta - gamma, beta, gamma);
    weights = weights.cwiseMax(0);
    return weights / weights.sum();
}

} // namespace

std::pair<double, double> MeshSample::unitSquare() const {
    const double s = 1 - weights[0];
    return {s * s, s > 0 ? weights[1] / s : 0.5};
}

void locate(const TestMesh &mesh, MeshSample &sample) {
    sample.distance = std::numeric_limits<double>::quiet_NaN();
    if (!sample.position.allFinite())
        return;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const Vector3d weights = nearestWeights(mesh, face, sample.position);
        Vector3d point = Vector3d::Zero();
        for (std::size_t i = 0; i < 3; ++i)
            point += weights[static_cast<Eigen::Index>(i)] * vertex(mesh, face, i);
        const double distance = (point - sample.position).norm();
        if (distance < nearest) {
            nearest = distance;
            sample.face = face;
            sample.weights = weights;
        }
    }
    sample.distance = nearest / std::sqrt(mesh.area());
}

Vector3d expectedNormal(const TestMesh &mesh, const MeshSample &sample) {
    if (mesh.normals.empty())
        return mesh.geometricNormal(sample.face);
    Vector3d normal = Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        normal += sample.weights[static_cast<Eigen::Index>(i)] *
                  mesh.normals[static_cast<std::size_t>(mesh.faces[sample.face][i])];
    return normal.normalized();
}

Vector2d expectedUv(const TestMesh &mesh, const MeshSample &sample) {
    Vector2d uv = Vector2d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        uv += sample.weights[static_cast<Eigen::Index>(i)] *
              mesh.uvs[static_cast<std::size_t>(mesh.faces[sample.face][i])];
    return uv;
}

MeshAnswer askMeshSamples(CheckContext &context, const TestScene &scene, int index,
                          const TestMesh &mesh, int count, std::uint64_t seed) {
    SceneRandom random(seed);
    protocol::RequestGroup group;
    group.files = scene.files();
    protocol::Request request;
    request.op = protocol::Op::MeshSample;
    request.text = TestScene::kFileName;
    request.index = static_cast<std::uint32_t>(index);
    for (int i = 0; i < 2 * count; ++i)
        request.values.push_back(random.nextFloat());
    group.requests.push_back(std::move(request));

    MeshAnswer result;
    const ProbeAnswer answer = context.ask(group);
    result.failure = unanswered(answer);
    if (result.failure)
        return result;
    const float *values = answer.responses[0].values.data();
    const std::size_t size = protocol::kMeshSampleSize;
    for (int i = 0; i < count; ++i, values += size) {
        MeshSample sample;
        sample.position = {values[0], values[1], values[2]};
        sample.normal = {values[3], values[4], values[5]};
        sample.uv = {values[6], values[7]};
        locate(mesh, sample);
        result.samples.push_back(sample);
    }
    return result;
}

} // namespace grader
