// SPDX-License-Identifier: MIT
#include "moment_rows.h"

#include <statistics/moments.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace battery {

namespace {

constexpr int kExactSide = 512; ///< midpoints of the square that stand for the density

/// Six moments at once: x, y, z and their squares.
class Moments {
public:
    void add(const catalog::Point &p) {
        const std::array<double, 3> at{p.x, p.y, p.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            m_running.at(axis).add(at.at(axis));
            m_running.at(axis + 3).add(at.at(axis) * at.at(axis));
        }
    }

    [[nodiscard]] statistics::MomentSummary summary(std::size_t moment) const {
        return m_running.at(moment).summary();
    }

private:
    std::array<statistics::RunningMoments, 6> m_running;
};

} // namespace

double MomentRow::z() const {
    return standardError > 0.0 ? (found - expected) / standardError : 0.0;
}

std::vector<MomentRow> momentRows(const catalog::WarpEntry &truth, double a,
                                  std::span<const Output> outputs) {
    constexpr std::array kNames{"mean of x",  "mean of y",  "mean of z",
                                "mean of x²", "mean of y²", "mean of z²"};
    Moments found;
    for (const Output &output : outputs) {
        const catalog::Point p = toPoint(output);
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) {
            found.add(p);
        }
    }
    Moments exact;
    for (int i = 0; i < kExactSide; ++i) {
        for (int j = 0; j < kExactSide; ++j) {
            exact.add(truth.warp({(i + 0.5) / kExactSide, (j + 0.5) / kExactSide}, a));
        }
    }
    std::vector<MomentRow> rows;
    for (std::size_t moment = 0; moment < kNames.size(); ++moment) {
        if (truth.dimension == 2 && moment % 3 == 2) {
            continue; // there is no z in the plane
        }
        const statistics::MomentSummary summary = found.summary(moment);
        rows.push_back({kNames.at(moment), summary.mean,
                        summary.count > 0.0 ? std::sqrt(summary.variance / summary.count) : 0.0,
                        exact.summary(moment).mean});
    }
    return rows;
}

} // namespace battery
