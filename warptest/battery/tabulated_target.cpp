// SPDX-License-Identifier: MIT
#include "tabulated_target.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace battery {

namespace {

using catalog::Chart;
using catalog::Point;
using catalog::Square;

constexpr double kCellTolerance = 1e-4; ///< of a cell's mass
constexpr int kMaxDepth = 6;            ///< of refinement: 64 times finer than the table

/// A rectangle of the unit square.
struct Cell {
    double u = 0.0;
    double v = 0.0;
    double height = 0.0; ///< along u
    double width = 0.0;  ///< along v

    [[nodiscard]] Square at(double s, double t) const { return {u + s * height, v + t * width}; }

    [[nodiscard]] std::array<Cell, 4> quarters() const {
        const double h = 0.5 * height;
        const double w = 0.5 * width;
        return {{{u, v, h, w}, {u, v + w, h, w}, {u + h, v, h, w}, {u + h, v + w, h, w}}};
    }
};

/// Asks a density at places of a chart, and counts what is none.
class ChartDensity {
public:
    ChartDensity(const Chart &chart, const Density &density) : m_chart(chart), m_density(density) {}

    /// Density per area of the unit square.
    std::vector<double> at(const std::vector<Square> &places) {
        std::vector<Output> points;
        points.reserve(places.size());
        for (const Square &place : places) {
            points.push_back(toOutput(m_chart.point(place)));
        }
        const std::vector<float> pdfs = m_density(points);
        if (pdfs.size() != places.size()) {
            throw std::invalid_argument("the density gave another number of answers than it was "
                                        "asked");
        }
        std::vector<double> values(places.size(), 0.0);
        for (std::size_t i = 0; i < places.size(); ++i) {
            notFinite += std::isfinite(pdfs[i]) ? 0 : 1;
            negative += pdfs[i] < 0.0F ? 1 : 0;
            if (std::isfinite(pdfs[i]) && pdfs[i] > 0.0F) {
                values[i] = static_cast<double>(pdfs[i]) * m_chart.stretch(places[i]);
            }
        }
        return values;
    }

    std::size_t notFinite = 0;
    std::size_t negative = 0;

private:
    const Chart &m_chart;
    const Density &m_density;
};

/// Masses of cells by 2x2 Gauss points.
std::vector<double> gauss(ChartDensity &density, const std::vector<Cell> &cells) {
    constexpr double kNode = 0.5 - 0.5 / std::numbers::sqrt3;
    std::vector<Square> places;
    for (const Cell &cell : cells) {
        for (const double s : {kNode, 1.0 - kNode}) {
            for (const double t : {kNode, 1.0 - kNode}) {
                places.push_back(cell.at(s, t));
            }
        }
    }
    const std::vector<double> values = density.at(places);
    std::vector<double> masses;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        masses.push_back(
            0.25 * cells[i].height * cells[i].width *
            (values[4 * i] + values[4 * i + 1] + values[4 * i + 2] + values[4 * i + 3]));
    }
    return masses;
}

std::vector<Cell> quartered(const std::vector<Cell> &cells) {
    std::vector<Cell> parts;
    for (const Cell &cell : cells) {
        for (const Cell &part : cell.quarters()) {
            parts.push_back(part);
        }
    }
    return parts;
}

/// Masses of cells, refined until halving a cell changes its mass by less than the tolerance, or
/// by less than `floor`.
std::vector<double> integrate(ChartDensity &density, const std::vector<Cell> &cells, double floor,
                              int depth = 0) {
    const std::vector<double> coarse = gauss(density, cells);
    if (depth == kMaxDepth) {
        return coarse;
    }
    const std::vector<Cell> parts = quartered(cells);
    const std::vector<double> fine = gauss(density, parts);
    std::vector<double> masses;
    std::vector<Cell> open;
    std::vector<std::size_t> openOf;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        masses.push_back(fine[4 * i] + fine[4 * i + 1] + fine[4 * i + 2] + fine[4 * i + 3]);
        const double change = std::fabs(masses[i] - coarse[i]);
        if (change > std::max(kCellTolerance * masses[i], floor)) {
            openOf.push_back(i);
            open.insert(open.end(), parts.begin() + static_cast<long>(4 * i),
                        parts.begin() + static_cast<long>(4 * i + 4));
        }
    }
    if (open.empty()) {
        return masses;
    }
    const std::vector<double> refined = integrate(density, open, 0.25 * floor, depth + 1);
    for (std::size_t k = 0; k < openOf.size(); ++k) {
        masses[openOf[k]] =
            refined[4 * k] + refined[4 * k + 1] + refined[4 * k + 2] + refined[4 * k + 3];
    }
    return masses;
}

/// Another rule: 3x3 midpoints of each cell, none of them a Gauss point.
double midpointSum(ChartDensity &density, const std::vector<Cell> &cells) {
    std::vector<Square> places;
    for (const Cell &cell : cells) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                places.push_back(cell.at((row + 0.5) / 3.0, (column + 0.5) / 3.0));
            }
        }
    }
    double sum = 0.0;
    for (const double value : density.at(places)) {
        sum += value;
    }
    return sum * cells.front().height * cells.front().width / 9.0;
}

/// Partial sums of the masses; linear in between.
struct Table {
    int rows = 0;
    int columns = 0;
    std::vector<double> rowSums;    ///< shape [rows + 1]
    std::vector<double> columnSums; ///< of each row, shape [rows, columns + 1]

    [[nodiscard]] const double *row(int i) const {
        return columnSums.data() + static_cast<std::ptrdiff_t>(i) * (columns + 1);
    }
};

/// Where `target` is among `count` + 1 partial sums, in [0, 1].
double invert(const double *sums, int count, double fraction, int &entry) {
    const double target = fraction * sums[count];
    const double *above = std::upper_bound(sums, sums + count + 1, target);
    entry = std::clamp(static_cast<int>(above - sums) - 1, 0, count - 1);
    while (entry > 0 && sums[entry + 1] <= sums[entry]) {
        --entry; // the last entries may be empty
    }
    const double mass = sums[entry + 1] - sums[entry];
    return mass > 0.0 ? std::clamp((target - sums[entry]) / mass, 0.0, 1.0) : 0.5;
}

/// Partial sum at `place` in [0, 1], as a fraction of the whole.
double accumulate(const double *sums, int count, double place, int &entry) {
    const double scaled = place * count;
    entry = std::clamp(static_cast<int>(scaled), 0, count - 1);
    const double inside = std::clamp(scaled - entry, 0.0, 1.0);
    const double sum = sums[entry] + inside * (sums[entry + 1] - sums[entry]);
    return sums[count] > 0.0 ? sum / sums[count] : 0.0;
}

bool isIn(const Square &s) {
    return s.u >= 0.0 && s.u <= 1.0 && s.v >= 0.0 && s.v <= 1.0;
}

int cellsAlong(int smooth) {
    return smooth * ((kTableSide + smooth - 1) / smooth);
}

Table makeTable(ChartDensity &density, const Chart &chart, TabulatedTarget &target) {
    Table table;
    table.rows = cellsAlong(chart.uCells);
    table.columns = cellsAlong(chart.vCells);
    const double height = 1.0 / table.rows;
    const double width = 1.0 / table.columns;
    double seen = 0.0; // mass so far: what is tiny beside it needs no refinement
    table.rowSums.push_back(0.0);
    for (int i = 0; i < table.rows; ++i) {
        std::vector<Cell> cells;
        cells.reserve(static_cast<std::size_t>(table.columns));
        for (int j = 0; j < table.columns; ++j) {
            cells.push_back({i * height, j * width, height, width});
        }
        double sum = 0.0;
        table.columnSums.push_back(sum);
        for (const double mass : integrate(density, cells, 1e-9 * seen)) {
            sum += mass;
            table.columnSums.push_back(sum);
        }
        seen += sum;
        table.rowSums.push_back(seen);
        target.checkIntegral += midpointSum(density, cells);
    }
    target.integral = seen;
    return table;
}

/// The whole sphere; in the plane a rectangle half as large again as what the chart covers.
void enlarge(const Chart &chart, catalog::WarpEntry &entry) {
    if (chart.dimension == 3) {
        entry.enlarged = catalog::zone(-1.0, 1.0).point;
        entry.enlargedMeasure = 4.0 * std::numbers::pi;
        return;
    }
    constexpr int kProbes = 33;
    Point low = chart.point({0.0, 0.0});
    Point high = low;
    for (int i = 0; i < kProbes; ++i) {
        for (int j = 0; j < kProbes; ++j) {
            const Point p = chart.point({i / (kProbes - 1.0), j / (kProbes - 1.0)});
            low = {std::min(low.x, p.x), std::min(low.y, p.y), 0.0};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), 0.0};
        }
    }
    const double dx = 0.25 * (high.x - low.x);
    const double dy = 0.25 * (high.y - low.y);
    entry.enlarged =
        catalog::rectangle({low.x - dx, low.y - dy, 0.0}, {high.x + dx, high.y + dy, 0.0}).point;
    entry.enlargedMeasure = (high.x - low.x + 2.0 * dx) * (high.y - low.y + 2.0 * dy);
}

} // namespace

bool TabulatedTarget::isReliable() const {
    return std::fabs(checkIntegral / integral - 1.0) <= kTableTolerance;
}

TabulatedTarget tabulateTarget(std::string id, const catalog::Chart &chart,
                               const Density &density) {
    TabulatedTarget target;
    ChartDensity onChart(chart, density);
    const auto table = std::make_shared<const Table>(makeTable(onChart, chart, target));
    target.notFinite = onChart.notFinite;
    target.negative = onChart.negative;
    if (!(target.integral > 0.0)) {
        throw std::invalid_argument("the density is 0 wherever it was asked");
    }
    const auto at = [density](const Point &p) {
        const Output point = toOutput(p);
        return static_cast<double>(density({&point, 1}).front());
    };
    catalog::WarpEntry &entry = target.entry;
    entry.id = std::move(id);
    entry.warpFunction = entry.id;
    entry.densityFunction = entry.id;
    entry.dimension = chart.dimension;
    entry.formula = [at, integral = target.integral](const Point &p, double) {
        return at(p) / integral;
    };
    entry.warp = [table, point = chart.point](const Square &s, double) {
        int row = 0;
        int column = 0;
        const double u = invert(table->rowSums.data(), table->rows, s.u, row);
        const double v = invert(table->row(row), table->columns, s.v, column);
        return point({(row + u) / table->rows, (column + v) / table->columns});
    };
    entry.rosenblatt = [table, place = chart.place](const Point &p, double) {
        const Square s = place(p);
        int row = 0;
        int column = 0;
        const double u = accumulate(table->rowSums.data(), table->rows, s.u, row);
        return Square{u, accumulate(table->row(row), table->columns, s.v, column)};
    };
    entry.conditioning = [](const Point &, double) {
        return 1.0;
    };
    entry.margin = [at, place = chart.place](const Point &p) {
        return isIn(place(p)) && at(p) > 0.0 ? 1.0 : -1.0;
    };
    enlarge(chart, entry);
    target.density = density;
    target.tabulated = [table, chart](const Point &p) {
        const Square s = chart.place(p);
        const int row = std::clamp(static_cast<int>(s.u * table->rows), 0, table->rows - 1);
        const int column =
            std::clamp(static_cast<int>(s.v * table->columns), 0, table->columns - 1);
        const double mass = table->row(row)[column + 1] - table->row(row)[column];
        return mass * table->rows * table->columns / chart.stretch(s);
    };
    return target;
}

bool ImportanceCheck::agrees() const {
    constexpr double kQuantile = 3.9; // two-sided 1e-4
    return std::fabs(mean - 1.0) <= kTableTolerance + kQuantile * standardError;
}

ImportanceCheck checkByImportance(const TabulatedTarget &target, std::span<const Output> outputs) {
    if (outputs.size() < 2) {
        throw std::invalid_argument("checkByImportance: at least two outputs are needed");
    }
    const std::vector<float> pdfs = target.density(outputs);
    ImportanceCheck check;
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const double ratio = target.tabulated(toPoint(outputs[i])) / static_cast<double>(pdfs[i]);
        if (!std::isfinite(ratio) || !(pdfs[i] > 0.0F)) {
            ++check.unseen;
            continue;
        }
        ++count;
        sum += ratio;
        squares += ratio * ratio;
    }
    if (count > 1.0) {
        check.mean = sum / count;
        check.standardError =
            std::sqrt(std::max(0.0, squares / count - check.mean * check.mean) / (count - 1.0));
    }
    return check;
}

} // namespace battery
