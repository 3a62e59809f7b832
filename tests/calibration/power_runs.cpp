// SPDX-License-Identifier: MIT
#include <grader/checks/radiance_comparison.h>
#include <statistics/binomial.h>
#include <statistics/tile_welch.h>

#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planted.h"
#include "runs.h"

namespace calibration {

namespace {

using grader::RadianceMoments;
using statistics::TileWelchResult;

constexpr int kReference = 3;       ///< times as many samples of the reference
constexpr std::size_t kChannel = 1; ///< green stands for all three
constexpr double kPower = 0.999;    ///< at a minimal detectable error
/// Of one statistic of a first stage, as in radiance_comparison.cpp.
constexpr double kLevel = 1e-4 / (grader::kLooks * 2 * 3 * 3);
/// Pixels that stand out are looked at again, as in radiance_case.cpp: 16 of them, three channels,
/// and tiles beside pixels.
constexpr double kPixelLevel = 1e-4 / (2 * 3 * 16);
constexpr int kPixelFactor = 64;
constexpr double kPixelError = 0.1; ///< relative: a smaller one does not count there

/// How often a statistic found a mistake, and how often its noise says that it must.
struct Rate {
    const char *statistic;
    std::size_t used = 0; ///< runs within the skewness gate
    std::size_t found = 0;
    double error = 0; ///< relative, as the recorded samples have it exactly
    double mde = 0;   ///< minimal detectable `error`
    double promised = 0;
};

/// Two-sided power of a Studentised mean after Hall's transform, where the true mean is `theta`
/// standard errors away and the mean's law has the skewness g: the transformed deviation has mean
/// theta + g theta^2 / 3 and deviation 1 + g theta / 6, up to g^2.
double powerOfMean(double theta, double g, double level) {
    const boost::math::normal normal;
    const double needed = quantile(complement(normal, level / 2));
    const double mean = theta + g * theta * theta / 3;
    const double deviation = 1 + g * theta / 6;
    return cdf(normal, (mean - needed) / deviation) + cdf(normal, (-mean - needed) / deviation);
}

/// What the runs say of one mean's noise, averaged.
struct Noise {
    double variance = 0; ///< of the difference
    double skewness = 0;

    void add(const statistics::MeanTestResult &test, double runs) {
        variance += test.standardError * test.standardError / runs;
        skewness += test.meanSkewness / runs;
    }

    double deviation() const { return std::sqrt(variance); }

    double theta(double difference) const { return variance > 0 ? difference / deviation() : 0; }
};

/// Exact means of the recorded samples.
struct Truth {
    std::vector<double> difference; ///< per tile, student minus ours
    std::vector<double> reference;

    Truth(const Recording &student, const Recording &ours)
        : difference(tileMeans(student.means(kChannel))),
          reference(tileMeans(ours.means(kChannel))) {
        for (std::size_t t = 0; t < difference.size(); ++t)
            difference[t] -= reference[t];
    }

    static double meanOf(const std::vector<double> &values) {
        double sum = 0;
        for (const double value : values)
            sum += value / static_cast<double>(values.size());
        return sum;
    }

private:
    static std::vector<double> tileMeans(const std::vector<double> &pixels) {
        constexpr std::size_t kTiles = kSide / kTileSize;
        std::vector<double> means(kTiles * kTiles);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            means[i / kSide / kTileSize * kTiles + i % kSide / kTileSize] +=
                pixels[i] / (kTileSize * kTileSize);
        return means;
    }
};

/// The three statistics of an image at a fixed number of samples per pixel.
class ImageRuns {
public:
    ImageRuns(const Recording &student, const Recording &ours)
        : m_student(student), m_ours(ours), m_truth(student, ours) {}

    std::vector<Rate> run(int repeats, int runs, statistics::Random &random) {
        m_global = {};
        m_tiles.assign(m_truth.difference.size(), {});
        m_tested = 0;
        Rate mean{"mean"};
        Rate squares{"sum of squares"};
        Rate worst{"worst tile"};
        const auto count = [](Rate &rate, bool gate, double p) {
            rate.used += gate ? 1 : 0;
            rate.found += gate && p <= kLevel ? 1 : 0;
        };
        for (int i = 0; i < runs; ++i) {
            const RadianceMoments a = m_student.draw(repeats, random);
            const RadianceMoments b = m_ours.draw(kReference * repeats, random);
            const TileWelchResult result = statistics::tileWelchTest(
                {kSide, kSide, a[kChannel]}, {kSide, kSide, b[kChannel]}, {.tileSize = kTileSize});
            count(mean, result.global.gateMet, result.global.pValue);
            count(squares, result.gateMet, result.sumPValue);
            count(worst, result.gateMet, result.maxPValue);
            m_global.add(result.global, runs);
            for (std::size_t t = 0; t < m_tiles.size(); ++t)
                m_tiles[t].add(result.tiles[t].test, runs);
            m_tested += static_cast<double>(result.tilesTested) / runs;
        }
        promiseMean(mean);
        promiseSquares(squares);
        promiseWorst(worst);
        return {mean, squares, worst};
    }

private:
    void promiseMean(Rate &rate) const {
        const double reference = Truth::meanOf(m_truth.reference);
        const double difference = Truth::meanOf(m_truth.difference);
        rate.error = std::fabs(difference) / reference;
        rate.mde =
            statistics::detectableDifference(m_global.deviation(), kLevel, kPower) / reference;
        rate.promised = powerOfMean(m_global.theta(difference), m_global.skewness, kLevel);
    }

    void promiseSquares(Rate &rate) const {
        double excess = 0; ///< of the sum of squares
        double whole = 0;  ///< excess if all tiles were 100 % off
        for (std::size_t t = 0; t < m_tiles.size(); ++t) {
            const double theta = m_tiles[t].theta(m_truth.difference[t]);
            const double mean = theta + m_tiles[t].skewness * theta * theta / 3;
            excess += mean * mean;
            whole += std::pow(m_tiles[t].theta(m_truth.reference[t]), 2);
            const double error =
                m_truth.reference[t] > 0 ? m_truth.difference[t] / m_truth.reference[t] : 0;
            rate.error += error * error / static_cast<double>(m_tiles.size());
        }
        rate.error = std::sqrt(rate.error);
        const double needed = quantile(complement(boost::math::chi_squared(m_tested), kLevel));
        rate.promised =
            excess > 0
                ? cdf(complement(boost::math::non_central_chi_squared(m_tested, excess), needed))
                : kLevel;
        const double excessNeeded =
            boost::math::non_central_chi_squared::find_non_centrality(m_tested, needed, 1 - kPower);
        rate.mde = excess > 0 ? rate.error * std::sqrt(excessNeeded / excess)
                              : std::sqrt(excessNeeded / whole);
    }

    void promiseWorst(Rate &rate) const {
        double missed = 1;
        double largest = 0;
        for (std::size_t t = 0; t < m_tiles.size(); ++t) {
            const double theta = m_tiles[t].theta(m_truth.difference[t]);
            missed *= 1 - powerOfMean(theta, m_tiles[t].skewness, kLevel / m_tested);
            // without any error, the tile with the least noise
            const double size = std::fabs(theta) + 1e-9 * m_tiles[t].theta(m_truth.reference[t]);
            if (size <= largest)
                continue;
            largest = size;
            rate.error = std::fabs(m_truth.difference[t]) / m_truth.reference[t];
            rate.mde = statistics::detectableDifference(m_tiles[t].deviation(), kLevel / m_tested,
                                                        kPower) /
                       m_truth.reference[t];
        }
        rate.promised = 1 - missed;
    }

    const Recording &m_student;
    const Recording &m_ours;
    Truth m_truth;
    Noise m_global;
    std::vector<Noise> m_tiles;
    double m_tested = 0; ///< tiles
};

/// The pixel that is most wrong, looked at again with more samples.
Rate runPixel(const Recording &student, const Recording &ours, int repeats, int runs,
              statistics::Random &random) {
    const std::vector<double> means = student.means(kChannel);
    const std::vector<double> wanted = ours.means(kChannel);
    const auto error = [&](std::size_t i) {
        return wanted[i] > 0 ? std::fabs(means[i] - wanted[i]) / wanted[i] : 0;
    };
    std::size_t worst = 0;
    for (std::size_t i = 1; i < means.size(); ++i)
        worst = error(i) > error(worst) ? i : worst;
    Rate rate{"worst pixel"};
    Noise noise;
    const auto draw = [&](const Recording &from) {
        const auto count = static_cast<std::uint32_t>(repeats * kPixelFactor);
        const std::vector<float> values = from.samples({static_cast<float>(worst)}, count, random);
        statistics::RunningMoments moments;
        for (std::size_t i = kChannel; i < values.size(); i += 3)
            moments.add(static_cast<double>(values[i]));
        return moments.summary();
    };
    for (int i = 0; i < runs; ++i) {
        const statistics::MeanTestResult test = statistics::welchTest(draw(student), draw(ours));
        rate.used += test.gateMet ? 1 : 0;
        rate.found += test.gateMet && test.pValue <= kPixelLevel ? 1 : 0;
        noise.add(test, runs);
    }
    rate.error = error(worst);
    if (wanted[worst] > 0)
        rate.mde = statistics::detectableDifference(noise.deviation(), kPixelLevel, kPower) /
                   wanted[worst];
    rate.promised =
        powerOfMean(noise.theta(means[worst] - wanted[worst]), noise.skewness, kPixelLevel);
    return rate;
}

/// Prints a rate. \return  whether it is the promised one
bool report(const Planted &planted, int repeats, const Rate &rate, int runs) {
    if (2 * rate.used < static_cast<std::size_t>(runs)) {
        fmt::print(
            "  {:<30} {:>5} {:<15} beyond the gate in {} of {} runs: more samples are taken\n",
            planted.name, repeats, rate.statistic, static_cast<std::size_t>(runs) - rate.used,
            runs);
        return true;
    }
    const statistics::Interval limits = statistics::clopperPearson(rate.found, rate.used, 1e-3);
    // The noise that the promise is made of is itself known to a few per cent only.
    constexpr double kSlack = 0.02;
    const bool kept = limits.lower <= rate.promised + kSlack &&
                      rate.promised - kSlack <= limits.upper &&
                      (rate.error < rate.mde || rate.found * 1000 >= 995 * rate.used);
    fmt::print("  {:<30} {:>5} {:<15} {:>5} runs: found {:>6.2f} %, promised {:>6.2f} %; off by "
               "{:.2f} %, would find {:.2f} %  {}\n",
               planted.name, repeats, rate.statistic, rate.used,
               100 * static_cast<double>(rate.found) / static_cast<double>(rate.used),
               100 * rate.promised, 100 * rate.error, 100 * rate.mde, kept ? "ok" : "OFF");
    return kept;
}

} // namespace

bool runPowerOfStatistics(int runs, const std::string &only, std::uint64_t seed) {
    bool good = true;
    const Recording ours(kPlantedScene, seed);
    statistics::Random random(statistics::deriveSeed(seed, "power"));
    fmt::print("Single statistics of the scene `{}` at a level of {:.2g}, and of a pixel at {:.2g} "
               "with {} times the\nsamples per pixel that stand here:\n",
               kPlantedScene, kLevel, kPixelLevel, kPixelFactor);
    for (const Planted &planted : plantedMistakes(only)) {
        Recording student(kPlantedScene, seed, planted.integrator);
        student.plant(planted.change);
        ImageRuns image(student, ours);
        for (const int repeats : {64, 256, 1024}) {
            const int count = std::max(10, runs * 64 / repeats);
            for (const Rate &rate : image.run(repeats, count, random))
                good = report(planted, repeats, rate, count) && good;
            const Rate pixel = runPixel(student, ours, repeats, count, random);
            if (pixel.error > kPixelError)
                good = report(planted, repeats, pixel, count) && good;
            std::fflush(stdout);
        }
    }
    return good;
}

} // namespace calibration
