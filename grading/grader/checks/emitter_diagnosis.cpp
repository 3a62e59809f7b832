// SPDX-License-Identifier: MIT
#include "emitter_diagnosis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace grader {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 0.01;

struct KnownLaw {
    int cosinePower;
    int distancePower;
    const char *diagnosis;
};

/// Powers of the ratio to distance^2 / (area * cosine).
constexpr double kLeastFit = 0.8; ///< of a constant factor

constexpr KnownLaw kLaws[] = {
    {1, -2, "area.pdf_area_measure"},  {0, -1, "area.pdf_distance_not_squared"},
    {1, 0, "area.pdf_cosine_missing"}, {2, -4, "area.pdf_reciprocal"},
    {0, 0, "area.pdf_factor"},
};

/// Solves the normal equations of log ratio = c + p log cosine + q log distance.
Vector3d fitPowers(const std::vector<DensityRatio> &ratios) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const DensityRatio &row : ratios) {
        const Vector3d x(1, std::log(row.cosine), std::log(row.distance));
        normal += x * x.transpose();
        right += x * std::log(row.ratio);
    }
    return normal.ldlt().solve(right);
}

double part(std::size_t count, std::size_t total) {
    return total > 0 ? static_cast<double>(count) / static_cast<double>(total) : 0;
}

/// Part of the distance of an angle's histogram from that of uniform directions that an evenly
/// spread angle explains, for the best of the three axes.
double fitOfEvenAngle(const std::vector<EmitterSampleRow> &rows) {
    constexpr std::size_t kBins = 32;
    double best = 0;
    for (int axis = 0; axis < 3; ++axis) {
        std::array<double, kBins> observed{};
        for (const EmitterSampleRow &row : rows) {
            const double turn = std::acos(std::clamp(row.wi[axis], -1.0, 1.0)) / kPi;
            const auto bin = static_cast<std::size_t>(turn * kBins);
            observed[std::min(kBins - 1, bin)] += 1 / static_cast<double>(rows.size());
        }
        double toEven = 0;
        double toRight = 0;
        for (std::size_t i = 0; i < kBins; ++i) {
            const double even = 1.0 / kBins;
            const auto edge = static_cast<double>(i);
            const double right =
                (std::cos(kPi * edge / kBins) - std::cos(kPi * (edge + 1) / kBins)) / 2;
            toEven += (observed[i] - even) * (observed[i] - even) / even;
            toRight += (observed[i] - right) * (observed[i] - right) / right;
        }
        const double noise = kBins / static_cast<double>(rows.size());
        if (toRight > 4 * noise)
            best = std::max(best, 1 - std::max(0.0, toEven - noise) / toRight);
    }
    return best;
}

/// True if the ray from `ref` along `direction` meets the unit sphere around the origin.
bool meetsUnitSphere(const EmitterSampleRow &row) {
    const double along = -row.ref.dot(row.wi);
    return along > 0 && (row.ref + along * row.wi).norm() <= 1 + 1e-3;
}

} // namespace

std::vector<Guess> guessAreaDensity(const std::vector<DensityRatio> &ratios) {
    std::vector<DensityRatio> usable;
    for (const DensityRatio &row : ratios) {
        if (std::isfinite(row.ratio) && row.ratio > 0 && row.cosine > 0 && row.distance > 0)
            usable.push_back(row);
    }
    if (usable.size() < ratios.size() / 2 || usable.size() < 8)
        return {{"area.pdf_wrong", kVagueFit}};
    const Vector3d powers = fitPowers(usable);
    const int cosine = static_cast<int>(std::lround(powers[1]));
    const int distance = static_cast<int>(std::lround(powers[2]));
    std::vector<double> constants;
    constants.reserve(usable.size());
    for (const DensityRatio &row : usable)
        constants.push_back(row.ratio / std::pow(row.cosine, cosine) /
                            std::pow(row.distance, distance));
    const auto middle = constants.begin() + static_cast<long>(constants.size() / 2);
    std::nth_element(constants.begin(), middle, constants.end());
    const double constant = *middle;
    const auto explained = std::count_if(constants.begin(), constants.end(), [&](double c) {
        return std::abs(c / constant - 1) <= kTolerance;
    });
    const double fit = part(static_cast<std::size_t>(explained), ratios.size());
    std::vector<Guess> guesses;
    // A factor of 1 for most, or one that is not the same for all, is none.
    const bool isNoLaw =
        cosine == 0 && distance == 0 && (fit < kLeastFit || std::abs(constant - 1) <= kTolerance);
    if (isNoLaw)
        return {{"area.pdf_wrong", kVagueFit}};
    for (const KnownLaw &law : kLaws) {
        if (law.cosinePower == cosine && law.distancePower == distance)
            guesses.push_back({law.diagnosis, fit});
    }
    if (guesses.empty() && cosine != 0)
        guesses.push_back({"area.pdf_cosine_power", 0.9 * fit});
    if (guesses.empty() || (distance != 0 && cosine != 0))
        guesses.push_back({"area.pdf_distance_power", 0.8 * fit});
    guesses.push_back({"area.pdf_wrong", kVagueFit});
    return guesses;
}

std::vector<Guess> guessSampleValue(const std::vector<EmitterSampleRow> &rows, const char *other) {
    std::size_t times = 0;
    std::size_t twice = 0;
    std::size_t lit = 0;
    for (const EmitterSampleRow &row : rows) {
        const auto is = [&](const Vector3d &value) {
            return (row.value - value).norm() <= kTolerance * value.norm();
        };
        lit += row.eval.norm() > 0 ? 1 : 0;
        times += row.eval.norm() > 0 && is(row.eval * row.pdf) ? 1 : 0;
        twice += row.eval.norm() > 0 && is(row.eval / (row.pdf * row.pdf)) ? 1 : 0;
    }
    return {{"area.value_times_pdf", part(times, lit)},
            {"area.value_divided_twice", part(twice, lit)},
            {other, 0.5}};
}

std::vector<Guess> guessDirections(const std::vector<EmitterSampleRow> &rows, bool uniform) {
    std::vector<Guess> guesses;
    std::size_t outside = 0;
    std::size_t meets = 0;
    double byChance = 0;
    for (const EmitterSampleRow &row : rows) {
        const double distance = row.ref.norm();
        if (distance < 1.1)
            continue;
        ++outside;
        meets += meetsUnitSphere(row) ? 1 : 0;
        byChance += (1 - std::sqrt(1 - 1 / (distance * distance))) / 2;
    }
    if (outside > 0) {
        const double chance = byChance / static_cast<double>(outside);
        guesses.push_back({"environment.direction_from_point",
                           std::max(0.0, (part(meets, outside) - chance) / (1 - chance))});
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto positive = std::count_if(rows.begin(), rows.end(),
                                            [&](const auto &row) { return row.wi[axis] > 0; });
        const double share = part(static_cast<std::size_t>(positive), rows.size());
        guesses.push_back(
            {"environment.hemisphere_only", std::max(share, 1 - share) > 0.999 ? 1.0 : 0.0});
    }
    guesses.push_back({"environment.uniform_in_map", fitOfEvenAngle(rows)});
    if (!uniform)
        guesses.push_back({"environment.map_mismatch", 0.7});
    guesses.push_back({"environment.not_uniform", kVagueFit});
    guesses.erase(std::remove_if(guesses.begin(), guesses.end(),
                                 [](const Guess &guess) { return guess.fit < kVagueFit; }),
                  guesses.end());
    return guesses;
}

std::vector<Guess> guessDirectionToLight(const std::vector<EmitterSampleRow> &rows) {
    std::size_t reversed = 0;
    std::size_t notUnit = 0;
    for (const EmitterSampleRow &row : rows) {
        const Vector3d right = (row.p - row.ref).normalized();
        const double length = row.wi.norm();
        reversed += (row.wi + right).norm() <= kTolerance ? 1 : 0;
        notUnit += length > 0 && std::abs(length - 1) > kTolerance &&
                           (row.wi / length - right).norm() <= kTolerance
                       ? 1
                       : 0;
    }
    return {{"area.wi_reversed", part(reversed, rows.size())},
            {"area.wi_not_unit", part(notUnit, rows.size())},
            {"area.wi_wrong", 0.5}};
}

} // namespace grader
