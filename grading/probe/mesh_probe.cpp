// SPDX-License-Identifier: MIT
#include <nori/mesh.h>
#include <probe/probe.h>

#include <stdexcept>

namespace probe {

Values answerMesh(const protocol::Request &request, const nori::Scene &scene) {
    const std::vector<nori::Mesh *> &meshes = scene.getMeshes();
    if (request.index >= meshes.size())
        throw std::out_of_range("the scene has no such mesh");
    const nori::Mesh &mesh = *meshes[request.index];
    Values values;
    values.reserve(request.resultSize());
    const float *at = request.values.data();
    const float *end = at + request.values.size();
    while (at < end) {
        if (request.op == protocol::Op::MeshDensity) {
            values.push_back(mesh.pdf(readVector<nori::Point3f>(at)));
            continue;
        }
        nori::Point3f p;
        nori::Normal3f n;
        nori::Point2f uv;
        mesh.samplePosition(readVector<nori::Point2f>(at), p, n, uv);
        probe::append(values, p);
        probe::append(values, n);
        probe::append(values, uv);
    }
    return values;
}

} // namespace probe
