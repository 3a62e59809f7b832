// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <window/point_view.h>

namespace viewer {

/// Where one looks from: a ball that the mouse rolls.
class Arcball {
public:
    /// From above for warps of the plane, from the side and a little above for directions.
    void reset(bool directions);
    /// \param from, to  places of the pointer, [-1, 1]^2 with y up
    void drag(std::array<float, 2> from, std::array<float, 2> to);
    /// Turns about the screen's axes [radians].
    void turn(float aboutX, float aboutY);
    void zoom(float factor);
    void setCenter(std::array<float, 3> center, float radius);

    /// \param aspect  width / height of the view
    [[nodiscard]] window::Matrix transform(float aspect) const;

private:
    void rotateBy(const std::array<float, 4> &q);

    std::array<float, 4> m_rotation{1.0F, 0.0F, 0.0F, 0.0F}; ///< unit quaternion w, x, y, z
    std::array<float, 3> m_center{};
    float m_radius = 1.0F;
    float m_zoom = 1.0F;
};

/// \return  x, y in [-1, 1] and the depth
std::array<float, 3> project(const window::Matrix &m, float x, float y, float z);

} // namespace viewer
