// SPDX-License-Identifier: MIT
#include <nori/mesh.h>
#include <nori/proplist.h>

#include <memory>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    static const ScratchFile file;
    nori::PropertyList properties;
    properties.setString("filename", file.write(bytes));
    try {
        const std::unique_ptr<nori::NoriObject> object(
            nori::NoriObjectFactory::createInstance("obj", properties));
        object->activate();
        const auto &mesh = static_cast<const nori::Mesh &>(*object);
        const auto &faces = mesh.getIndices();
        require(faces.cols() > 0 && faces.maxCoeff() < mesh.getVertexCount(),
                "a mesh has triangles, of vertices that are there");
        require(mesh.getVertexPositions().allFinite(), "vertices are finite");
    } catch (const nori::NoriException &) {
    }
}
