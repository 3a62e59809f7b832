// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include <viewer/arcball.h>

namespace viewer {

namespace {

constexpr float kDegree = 3.14159265F / 180.0F;

/// \see K. Shoemake, "ARCBALL", Graphics Interface 1992
Eigen::Vector3f onBall(std::array<float, 2> place) {
    const float square = place[0] * place[0] + place[1] * place[1];
    if (square > 1.0F) {
        return Eigen::Vector3f(place[0], place[1], 0.0F).normalized();
    }
    return {place[0], place[1], std::sqrt(1.0F - square)};
}

Eigen::Quaternionf toEigen(const std::array<float, 4> &q) {
    return {q[0], q[1], q[2], q[3]};
}

std::array<float, 4> fromEigen(const Eigen::Quaternionf &q) {
    return {q.w(), q.x(), q.y(), q.z()};
}

} // namespace

void Arcball::rotateBy(const std::array<float, 4> &q) {
    m_rotation = fromEigen((toEigen(q) * toEigen(m_rotation)).normalized());
}

void Arcball::reset(bool directions) {
    m_rotation = {1.0F, 0.0F, 0.0F, 0.0F};
    m_zoom = 1.0F;
    if (directions) {
        const Eigen::Quaternionf spin(
            Eigen::AngleAxisf(-30.0F * kDegree, Eigen::Vector3f::UnitZ()));
        const Eigen::Quaternionf tilt(
            Eigen::AngleAxisf(-62.0F * kDegree, Eigen::Vector3f::UnitX()));
        m_rotation = fromEigen(tilt * spin);
    }
}

void Arcball::drag(std::array<float, 2> from, std::array<float, 2> to) {
    rotateBy(fromEigen(Eigen::Quaternionf::FromTwoVectors(onBall(from), onBall(to))));
}

void Arcball::turn(float aboutX, float aboutY) {
    const Eigen::Quaternionf q(Eigen::AngleAxisf(aboutX, Eigen::Vector3f::UnitX()) *
                               Eigen::AngleAxisf(aboutY, Eigen::Vector3f::UnitY()));
    rotateBy(fromEigen(q));
}

void Arcball::zoom(float factor) {
    m_zoom = std::clamp(m_zoom * factor, 0.2F, 50.0F);
}

void Arcball::setCenter(std::array<float, 3> center, float radius) {
    m_center = center;
    m_radius = radius;
}

window::Matrix Arcball::transform(float aspect) const {
    Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
    const float scale = m_zoom / m_radius;
    m.topLeftCorner<3, 3>() = toEigen(m_rotation).toRotationMatrix() * scale;
    m.topRightCorner<3, 1>() =
        -(m.topLeftCorner<3, 3>() * Eigen::Vector3f(m_center[0], m_center[1], m_center[2]));
    // orthographic: sizes can be compared; the shorter side of the view shows the whole ball
    m.row(0) *= aspect > 1.0F ? 1.0F / aspect : 1.0F;
    m.row(1) *= aspect > 1.0F ? 1.0F : aspect;
    m.row(2) *= -0.05F / std::max(1.0F, m_zoom);
    m(3, 3) = 1.0F;
    window::Matrix result{};
    std::copy(m.data(), m.data() + 16, result.begin());
    return result;
}

std::array<float, 3> project(const window::Matrix &m, float x, float y, float z) {
    std::array<float, 3> at{};
    for (std::size_t row = 0; row < 3; ++row) {
        at[row] = m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row];
    }
    return at;
}

} // namespace viewer
