// SPDX-License-Identifier: MIT
#include "point_picture.h"

#include <battery/domain_map.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace grader {

namespace {

constexpr std::size_t kMostPoints = 3000;

/// Where a point is drawn, in [0, 1]^2 upwards, and whether it is on the near side.
struct Drawn {
    double x = 0.0;
    double y = 0.0;
    bool isNear = true;
};

/// Seen from azimuth -60 and elevation 25 degrees.
Drawn project(const catalog::Point &p) {
    constexpr double kAzimuth = -1.0472;
    constexpr double kElevation = 0.4363;
    const double right = -p.x * std::sin(kAzimuth) + p.y * std::cos(kAzimuth);
    const double back = p.x * std::cos(kAzimuth) + p.y * std::sin(kAzimuth);
    const double up = p.z * std::cos(kElevation) - back * std::sin(kElevation);
    const double toward = p.z * std::sin(kElevation) + back * std::cos(kElevation);
    return {0.5 + 0.48 * right, 0.5 + 0.48 * up, toward >= 0.0};
}

std::string picture(const std::string &name, std::size_t count, std::size_t step,
                    const std::function<Drawn(std::size_t)> &place) {
    std::array<std::string, 2> paths;
    for (std::size_t i = 0; i < count; i += step) {
        const Drawn at = place(i);
        if (!std::isfinite(at.x) || !std::isfinite(at.y) || std::fabs(at.x) > 10.0 ||
            std::fabs(at.y) > 10.0)
            continue; // out of the picture
        // a line of length 0 with round ends is a dot
        paths.at(at.isNear ? 1 : 0) +=
            fmt::format("M{:.0f} {:.0f}h0", 1000.0 * at.x, 1000.0 * (1.0 - at.y));
    }
    std::string svg;
    for (std::size_t near = 0; near < 2; ++near)
        svg += fmt::format(R"(<path d="{}" stroke-opacity="{}"/>)", paths.at(near),
                           near == 1 ? 0.8 : 0.25);
    return fmt::format("<figure class=\"map\"><figcaption><strong>{0}</strong></figcaption>\n"
                       "<svg role=\"img\" aria-label=\"{0}\" viewBox=\"-10 -10 1020 1020\" "
                       "fill=\"none\" stroke=\"currentColor\" stroke-width=\"7\" "
                       "stroke-linecap=\"round\"><path d=\"M0 0H1000V1000H0z\" stroke-width=\"2\" "
                       "stroke-opacity=\"0.4\"/>{1}</svg></figure>\n",
                       name, svg);
}

} // namespace

std::string pointPictures(const catalog::WarpEntry &truth, std::span<const battery::Input> inputs,
                          std::span<const battery::Output> outputs, const std::string &pointSet) {
    const std::size_t count = std::min(inputs.size(), outputs.size());
    const std::size_t step = std::max<std::size_t>(1, (count + kMostPoints - 1) / kMostPoints);
    const battery::DomainMap domain = battery::makeDomainMap(truth);
    std::string html = "<div class=\"maps\">\n";
    html += picture("Samples: " + pointSet, count, step, [&](std::size_t i) {
        return Drawn{static_cast<double>(inputs[i].u), static_cast<double>(inputs[i].v)};
    });
    html += picture(domain.directions ? "Directions, from above and aside" : "Points", count, step,
                    [&](std::size_t i) {
                        const catalog::Point p = battery::toPoint(outputs[i]);
                        if (domain.directions)
                            return project(p);
                        const std::array<double, 2> at = domain.place(p);
                        return Drawn{at[0], at[1]};
                    });
    return html + "</div>\n";
}

} // namespace grader
