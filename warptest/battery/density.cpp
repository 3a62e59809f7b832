// SPDX-License-Identifier: MIT
#include "density.h"

#include <statistics/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace battery {

namespace {

/// Below this, single precision may underflow; what is returned is then compared with
/// kNegligible only.
constexpr double kSmallDensity = 1e-20;
constexpr double kNegligible = 1e-15;

float step(float x, int ulps) {
    for (int i = 0; i < std::abs(ulps); ++i) {
        x = std::nextafter(x, ulps > 0 ? 10.0F : -10.0F);
    }
    return x;
}

/// Relative error that rounding to single precision explains.
double relativeTolerance(const catalog::WarpEntry &entry, const catalog::Point &p, double a) {
    return 1e-4 + 4.0 * catalog::kFloatRounding * entry.conditioning(p, a);
}

bool isRight(const catalog::WarpEntry &entry, const catalog::Point &p, double a, double pdf) {
    const double exact = entry.density(p, a);
    if (exact < kSmallDensity) {
        return pdf >= 0.0 && pdf <= (exact > 0.0 ? kNegligible : 0.0);
    }
    return std::fabs(pdf / exact - 1.0) <= relativeTolerance(entry, p, a);
}

/// Rounding of a cosine at the horizon that is recovered from the sine: sqrt(4 * 2^-24).
constexpr double kHorizonRounding = 5e-4;

/// At the boundary the density of either side will do.
bool isRightAtBoundary(const catalog::WarpEntry &entry, const catalog::Point &p, double a,
                       double pdf) {
    const double inside = std::fabs(entry.formula(p, a));
    return pdf == 0.0 || std::fabs(pdf - inside) <= 1e-3 * inside + kHorizonRounding;
}

bool isAtBoundary(const catalog::WarpEntry &entry, const catalog::Point &p) {
    return entry.boundary != nullptr && std::fabs(entry.margin(p)) <= catalog::kBoundaryBand;
}

void addBoundaryQueries(const catalog::WarpEntry &entry, DensityQueries &queries) {
    constexpr int kPlaces = 64;
    constexpr std::array<int, 8> kSteps{-16, -4, -2, -1, 1, 2, 4, 16};
    for (int i = 0; i < kPlaces && entry.boundary != nullptr; ++i) {
        const Output on = toOutput(entry.boundary((i + 0.5) / kPlaces));
        for (const int ulps : kSteps) {
            // In the plane along both axes; on the sphere the boundary is z = 0, whose neighbours
            // in single precision are so dense that they are stepped as multiples of 2^-24.
            if (entry.dimension == 2) {
                queries.points.push_back({step(on.x, ulps), on.y, on.z});
                queries.points.push_back({on.x, step(on.y, ulps), on.z});
            } else {
                queries.points.push_back({on.x, on.y, static_cast<float>(ulps) * 0x1p-24F});
            }
        }
        if (entry.dimension == 3) {
            queries.points.push_back({on.x, on.y, 0.0F});
        }
    }
    queries.kinds.resize(queries.points.size(), QueryKind::Boundary);
}

/// Collects what is found, point by point.
class DensityJudge {
public:
    DensityJudge(const catalog::WarpEntry &entry, double a) : m_entry(entry), m_a(a) {}

    void add(std::size_t index, const Output &output, QueryKind kind, float returned) {
        const catalog::Point p = toPoint(output);
        const auto pdf = static_cast<double>(returned);
        if (isAtBoundary(m_entry, p) || kind == QueryKind::Boundary) {
            ++m_result.boundaryPoints;
            m_result.wrongAtBoundary += isRightAtBoundary(m_entry, p, m_a, pdf) ? 0 : 1;
            return;
        }
        m_result.notFinite += std::isfinite(pdf) ? 0 : 1;
        m_result.negative += pdf < 0.0 ? 1 : 0;
        if (m_entry.margin(p) < 0.0) {
            addOutside(index, pdf);
            return;
        }
        const bool right = isRight(m_entry, p, m_a, pdf);
        (kind == QueryKind::Target ? m_result.targetPoints : m_result.insidePoints) += 1;
        if (!right) {
            (kind == QueryKind::Target ? m_result.wrongAtTarget : m_result.wrongInside) += 1;
            if (kind == QueryKind::Target && pdf == 0.0) {
                ++m_result.zeroAtTarget;
                m_result.zeroDepth = std::max(m_result.zeroDepth, m_entry.margin(p));
            }
        }
        addRatio(index, p, kind, pdf);
    }

    DensityResult finish(std::size_t domainPoints) {
        if (domainPoints > 0) {
            const double perPoint = m_entry.enlargedMeasure / static_cast<double>(domainPoints);
            m_result.outsideMass = m_outsideSum * perPoint;
            m_result.outsideSize = m_outsideSize * perPoint;
        }
        if (!m_ratios.empty()) {
            const auto middle = m_ratios.begin() + static_cast<long>(m_ratios.size() / 2);
            std::nth_element(m_ratios.begin(), middle, m_ratios.end());
            m_result.medianRatio = *middle;
        }
        if (!m_samples.empty()) {
            m_result.ratio = catalog::explainRatio(m_samples, m_entry.hasParameter ? m_a : 0.0);
        }
        return m_result;
    }

private:
    void addOutside(std::size_t index, double pdf) {
        ++m_result.outsidePoints;
        if (pdf == 0.0) {
            return;
        }
        ++m_result.nonZeroOutside;
        const double size =
            std::isfinite(pdf) ? std::fabs(pdf) : std::numeric_limits<double>::infinity();
        m_outsideSum += std::isfinite(pdf) ? pdf : 0.0;
        m_outsideSize += size;
        if (size > m_worstOutside) {
            m_worstOutside = size;
            m_result.worstOutside = index;
        }
    }

    void addRatio(std::size_t index, const catalog::Point &p, QueryKind kind, double pdf) {
        const double exact = m_entry.density(p, m_a);
        if (exact < kSmallDensity) {
            return;
        }
        const double ratio = pdf / exact;
        const double error =
            std::isfinite(ratio) ? std::fabs(ratio - 1.0) : std::numeric_limits<double>::infinity();
        if (error > m_result.maxRelativeError) {
            m_result.maxRelativeError = error;
            m_result.worst = index;
            m_result.worstExact = exact;
        }
        if (kind == QueryKind::Target && std::isfinite(ratio)) {
            m_ratios.push_back(ratio);
            m_samples.push_back({ratio, m_entry.dimension == 3 ? p.z : 1.0});
        }
    }

    const catalog::WarpEntry &m_entry;
    double m_a;
    DensityResult m_result;
    std::vector<double> m_ratios;
    std::vector<catalog::RatioSample> m_samples;
    double m_outsideSum = 0.0;
    double m_outsideSize = 0.0;
    double m_worstOutside = 0.0;
};

bool fits(const catalog::WarpEntry &entry, double a, const catalog::DensityMistake &mistake,
          const DensityQueries &queries, std::span<const float> pdfs) {
    std::size_t looked = 0;
    std::size_t missed = 0;
    for (std::size_t i = 0; i < pdfs.size(); ++i) {
        const catalog::Point p = toPoint(queries.points[i]);
        // Where the right density is 0 to single precision, a test for that may come first.
        const bool isNegligible = entry.margin(p) >= 0.0 && entry.density(p, a) < kSmallDensity;
        if (queries.kinds[i] == QueryKind::Boundary || isAtBoundary(entry, p) || isNegligible) {
            continue;
        }
        ++looked;
        const double predicted = mistake.density(p, a);
        const double tolerance = 1e-3 + 4.0 * catalog::kFloatRounding * entry.conditioning(p, a);
        const double distance = std::fabs(static_cast<double>(pdfs[i]) - predicted);
        if (!(distance <= std::min(0.1, tolerance) * std::fabs(predicted) + kNegligible)) {
            ++missed;
        }
    }
    return static_cast<double>(missed) <= 0.01 * static_cast<double>(looked);
}

const catalog::DensityMistake *findMistake(const catalog::WarpEntry &entry, double a,
                                           const DensityQueries &queries,
                                           std::span<const float> pdfs) {
    for (const catalog::DensityMistake &mistake : catalog::densityMistakes()) {
        if (mistake.warpId == entry.id && fits(entry, a, mistake, queries, pdfs)) {
            return &mistake;
        }
    }
    return nullptr;
}

} // namespace

DensityQueries densityQueries(const catalog::WarpEntry &entry, double a, std::uint64_t seed,
                              std::size_t count) {
    statistics::Random random(seed);
    DensityQueries queries;
    for (std::size_t i = 0; i < count; ++i) {
        catalog::Square s;
        s.u = random.nextDouble();
        s.v = random.nextDouble();
        const bool target = i < count / 2;
        queries.points.push_back(toOutput(target ? entry.warp(s, a) : entry.enlarged(s)));
        queries.kinds.push_back(target ? QueryKind::Target : QueryKind::Domain);
    }
    addBoundaryQueries(entry, queries);
    return queries;
}

DensityResult judgeDensity(const catalog::WarpEntry &entry, double a, const DensityQueries &queries,
                           std::span<const float> pdfs) {
    if (pdfs.size() != queries.points.size() || queries.kinds.size() != queries.points.size()) {
        throw std::invalid_argument("judgeDensity: one density per query is needed");
    }
    DensityJudge judge(entry, a);
    std::size_t domainPoints = 0;
    for (std::size_t i = 0; i < pdfs.size(); ++i) {
        judge.add(i, queries.points[i], queries.kinds[i], pdfs[i]);
        domainPoints += queries.kinds[i] == QueryKind::Domain ? 1 : 0;
    }
    DensityResult result = judge.finish(domainPoints);
    if (!result.rightInside() || !result.rightOutside() || result.negative > 0) {
        result.mistake = findMistake(entry, a, queries, pdfs);
    }
    return result;
}

} // namespace battery
