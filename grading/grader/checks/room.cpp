// SPDX-License-Identifier: MIT
#include "room.h"

namespace grader {

Room::Room(std::uint64_t seed)
    : random(seed),
      pose(random.rigid(1.5)),
      albedo(random.color(0.3, 0.8)),
      floor(parallelogram({-1.1, -0.9, 0}, {2.1, 0, 0}, {0, 1.9, 0}).transformed(pose)) {
    scene.addMesh(floor, albedo);
}

TestMesh Room::lightMesh(const Vector3d &center, double width, double depth) const {
    const Vector3d a(width, 0.2 * width, 0.1 * width);
    const Vector3d b(-0.1 * depth, -depth, 0.15 * depth);
    return parallelogram(center - 0.5 * a - 0.5 * b, a, b).transformed(pose);
}

Vector3d Room::world(const Vector3d &local) const {
    return (pose * local).cast<float>().cast<double>();
}

RadianceCase Room::onFloor() {
    RadianceCase test;
    test.columns = kColumns;
    test.rays = raysOnto(floor, kColumns, 0.35, random);
    return test;
}

} // namespace grader
