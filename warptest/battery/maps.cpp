// SPDX-License-Identifier: MIT
#include <battery/maps.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace battery {

namespace {

std::size_t cellCount(int side) {
    return static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
}

/// Integral of the density over each cell by the midpoint rule. For directions the steps crowd
/// below the upper edge (t^4), since a narrow lobe lies within a ten-thousandth of the map there.
std::vector<double> cellMasses(const catalog::WarpEntry &truth, const DomainMap &domain, double a,
                               int side) {
    const std::size_t cells = cellCount(side);
    const auto columns = static_cast<std::size_t>(side);
    const int across = domain.directions ? 4 : 24;
    const int up = domain.directions ? 256 : 24;
    const double area = domain.measure() / (static_cast<double>(cells) * across * up);
    const auto fromTop = [&](double t) {
        return domain.directions ? t * t * t * t : t;
    };
    const auto slope = [&](double t) {
        return domain.directions ? 4.0 * t * t * t : 1.0;
    };
    std::vector<double> masses(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const std::size_t column = cell % columns;
        const std::size_t row = cell / columns;
        double sum = 0.0;
        for (int i = 0; i < across; ++i) {
            for (int j = 0; j < up; ++j) {
                const double t = (j + 0.5) / up;
                const catalog::Point p =
                    domain.point({(static_cast<double>(column) + (i + 0.5) / across) / side,
                                  (static_cast<double>(row) + 1.0 - fromTop(t)) / side});
                sum += truth.density(p, a) * slope(t);
            }
        }
        masses[cell] = sum * area;
    }
    return masses;
}

} // namespace

std::size_t worstCell(const Maps &maps) {
    const auto worst =
        std::max_element(maps.residual.begin(), maps.residual.end(),
                         [](double a, double b) { return std::fabs(a) < std::fabs(b); });
    return worst == maps.residual.end() ? 0
                                        : static_cast<std::size_t>(worst - maps.residual.begin());
}

int cellAt(const std::array<double, 2> &place, int side) {
    const auto index = [side](double x) {
        // the upper edge belongs to the map: cos(theta) may be 1
        return x >= 0.0 && x <= 1.0 ? std::min(static_cast<int>(x * side), side - 1) : -1;
    };
    const int column = index(place[0]);
    const int row = index(place[1]);
    return column < 0 || row < 0 ? -1 : row * side + column;
}

Maps mapsOfCounts(const catalog::WarpEntry &truth, double a, std::vector<double> observed,
                  std::size_t points) {
    Maps maps;
    maps.domain = makeDomainMap(truth);
    maps.side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(observed.size()))));
    const std::size_t cells = cellCount(maps.side);
    if (observed.empty() || observed.size() != cells) {
        throw std::invalid_argument("mapsOfCounts: the counts are no square");
    }
    maps.points = points;
    maps.observed = std::move(observed);
    double inside = 0.0;
    for (const double count : maps.observed) {
        inside += count;
    }
    maps.outside = points - std::min(points, static_cast<std::size_t>(inside));
    maps.expected = cellMasses(truth, maps.domain, a, maps.side);
    maps.residual.assign(cells, 0.0);
    maps.sparse.assign(cells, false);
    for (std::size_t i = 0; i < cells; ++i) {
        maps.expected[i] *= static_cast<double>(points);
        const double difference = maps.observed[i] - maps.expected[i];
        maps.sparse[i] = maps.expected[i] < kMinExpected && maps.observed[i] < 4 * kMinExpected;
        if (!maps.sparse[i]) {
            maps.residual[i] = difference / std::sqrt(std::max(maps.expected[i], kMinExpected));
        }
        maps.largest = std::max({maps.largest, maps.observed[i], maps.expected[i]});
    }
    return maps;
}

std::vector<double> countCells(const DomainMap &domain, std::span<const Output> outputs, int side) {
    std::vector<double> observed(cellCount(side), 0.0);
    for (const Output &output : outputs) {
        const int cell = cellAt(domain.place(toPoint(output)), side);
        if (cell >= 0) {
            observed[static_cast<std::size_t>(cell)] += 1.0;
        }
    }
    return observed;
}

Maps makeMaps(const catalog::WarpEntry &truth, double a, std::span<const Output> outputs,
              int side) {
    return mapsOfCounts(truth, a, countCells(makeDomainMap(truth), outputs, side), outputs.size());
}

} // namespace battery
