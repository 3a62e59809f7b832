// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <viewer/maps.h>

namespace viewer {

namespace {

constexpr std::size_t kCells = static_cast<std::size_t>(kMapSide) * kMapSide;

/// Integral of the density over each cell by the midpoint rule. For directions the steps crowd
/// below the upper edge (t^4), since a narrow lobe lies within a ten-thousandth of the chart there.
std::vector<double> cellMasses(const catalog::WarpEntry &truth, const Chart &chart, double a) {
    const int across = chart.directions ? 4 : 24;
    const int up = chart.directions ? 256 : 24;
    const double area = chart.measure() / (static_cast<double>(kCells) * across * up);
    const auto fromTop = [&](double t) {
        return chart.directions ? t * t * t * t : t;
    };
    const auto slope = [&](double t) {
        return chart.directions ? 4.0 * t * t * t : 1.0;
    };
    std::vector<double> masses(kCells);
    for (std::size_t cell = 0; cell < kCells; ++cell) {
        const std::size_t column = cell % kMapSide;
        const std::size_t row = cell / kMapSide;
        double sum = 0.0;
        for (int i = 0; i < across; ++i) {
            for (int j = 0; j < up; ++j) {
                const double t = (j + 0.5) / up;
                const catalog::Point p =
                    chart.point({(static_cast<double>(column) + (i + 0.5) / across) / kMapSide,
                                 (static_cast<double>(row) + 1.0 - fromTop(t)) / kMapSide});
                sum += truth.density(p, a) * slope(t);
            }
        }
        masses[cell] = sum * area;
    }
    return masses;
}

} // namespace

int cellAt(const std::array<double, 2> &place) {
    const auto index = [](double x) {
        // the upper edge belongs to the chart: cos(theta) may be 1
        return x >= 0.0 && x <= 1.0 ? std::min(static_cast<int>(x * kMapSide), kMapSide - 1) : -1;
    };
    const int column = index(place[0]);
    const int row = index(place[1]);
    return column < 0 || row < 0 ? -1 : row * kMapSide + column;
}

Maps makeMaps(const catalog::WarpEntry &truth, double a, std::span<const battery::Output> outputs) {
    Maps maps;
    maps.chart = makeChart(truth);
    maps.points = outputs.size();
    maps.observed.assign(kCells, 0.0);
    for (const battery::Output &output : outputs) {
        const int cell = cellAt(maps.chart.place(battery::toPoint(output)));
        if (cell < 0) {
            ++maps.outside;
        } else {
            maps.observed[static_cast<std::size_t>(cell)] += 1.0;
        }
    }
    maps.expected = cellMasses(truth, maps.chart, a);
    maps.residual.assign(kCells, 0.0);
    maps.sparse.assign(kCells, false);
    for (std::size_t i = 0; i < kCells; ++i) {
        maps.expected[i] *= static_cast<double>(outputs.size());
        const double difference = maps.observed[i] - maps.expected[i];
        maps.sparse[i] = maps.expected[i] < kMinExpected && maps.observed[i] < 4 * kMinExpected;
        if (!maps.sparse[i]) {
            maps.residual[i] = difference / std::sqrt(std::max(maps.expected[i], kMinExpected));
        }
        maps.largest = std::max({maps.largest, maps.observed[i], maps.expected[i]});
    }
    return maps;
}

} // namespace viewer
