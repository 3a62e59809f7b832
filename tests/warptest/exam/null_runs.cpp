// SPDX-License-Identifier: MIT
#include <statistics/binomial.h>
#include <statistics/chi_square.h>
#include <statistics/random.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <vector>

#include "configurations.h"
#include "runs.h"

namespace warp_exam {

namespace {

constexpr std::array<double, 3> kLevels{1e-2, 1e-3, 1e-4};
constexpr double kLimit = 1e-3; ///< of the binomial limits
/// Statistics: the four histograms, the four together, and these with the tolerance zone.
constexpr std::array<const char *, 6> kStatistics{"32x32",    "8x8",      "256 in U",
                                                  "256 in V", "combined", "as used"};
/// Where no rounding shows, so that the null is true to the last digit.
constexpr double kAlpha = 0.3;

/// How often each statistic was at most each level.
using Counts = std::array<std::array<std::uint64_t, kLevels.size()>, kStatistics.size()>;

void count(double pValue, std::size_t statistic, Counts &counts) {
    for (std::size_t i = 0; i < kLevels.size(); ++i) {
        counts[statistic][i] += pValue <= kLevels[i] ? 1 : 0;
    }
}

/// Histograms of one run, in portions that stay in the processor's cache.
std::array<battery::Histogram, 4> countSamples(const Configuration &item, std::size_t samples,
                                               std::uint64_t seed) {
    constexpr std::size_t kPortion = 8192;
    statistics::Random random(seed);
    std::array<battery::Histogram, 4> sum;
    for (std::size_t first = 0; first < samples; first += kPortion) {
        const std::size_t portion = std::min(kPortion, samples - first);
        const std::array<battery::Histogram, 4> part = battery::countHistograms(
            battery::toUnitSquare(*item.target, item.a,
                                  item.warp(battery::randomInputs(portion, random.nextBits()))));
        for (std::size_t i = 0; i < sum.size(); ++i) {
            if (first == 0) {
                sum[i] = part[i];
                continue;
            }
            for (std::size_t cell = 0; cell < sum[i].counts.size(); ++cell) {
                sum[i].counts[cell] += part[i].counts[cell];
            }
        }
    }
    return sum;
}

/// p-values of one run. The tolerance zone makes a p-value larger, never smaller.
void countRun(const Configuration &item, std::size_t samples, std::uint64_t seed, Counts &counts) {
    const auto total = static_cast<double>(samples);
    const std::array<battery::Histogram, 4> histograms = countSamples(item, samples, seed);
    double least = 1.0;
    double leastUsed = 1.0;
    for (std::size_t i = 0; i < histograms.size(); ++i) {
        const statistics::ChiSquareResult found =
            statistics::chiSquareEqualCells(histograms[i].counts, total);
        count(found.pValue, i, counts);
        least = std::min(least, found.pValue);
        if (found.pValue <= kLevels.front()) {
            leastUsed = std::min(leastUsed, statistics::toleranceZonePValue(
                                                found.statistic, found.degreesOfFreedom, total,
                                                catalog::distributionTolerance(
                                                    *item.target, item.a, histograms[i].uBins)));
        }
    }
    count(std::min(1.0, 4.0 * least), 4, counts);
    count(std::min(1.0, 4.0 * leastUsed), 5, counts);
}

Counts countRuns(const Configuration &item, const NullOptions &options) {
    constexpr std::size_t kChunk = 100;
    const auto runs = static_cast<std::size_t>(options.runs);
    Counts sum{};
    std::mutex mutex;
    forEach(item.name, (runs + kChunk - 1) / kChunk, [&](std::size_t chunk) {
        Counts counts{};
        for (std::size_t run = chunk * kChunk; run < std::min(runs, (chunk + 1) * kChunk); ++run) {
            countRun(item, options.samples,
                     statistics::deriveSeed(options.seed, item.name, 0, static_cast<unsigned>(run)),
                     counts);
        }
        const std::scoped_lock lock(mutex);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            for (std::size_t k = 0; k < kLevels.size(); ++k) {
                sum[i][k] += counts[i][k];
            }
        }
    });
    return sum;
}

/// How many of the counts are out of their limits. The combined ones only bound their level.
struct Limits {
    int checked = 0;
    int off = 0;
};

void print(const Configuration &item, const Counts &counts, int runs, Limits &limits) {
    for (std::size_t i = 0; i < kStatistics.size(); ++i) {
        std::string line = fmt::format("{:<44} {:<9}", item.name, kStatistics[i]);
        for (std::size_t k = 0; k < kLevels.size(); ++k) {
            const statistics::Interval interval =
                statistics::clopperPearson(counts[i][k], static_cast<std::uint64_t>(runs), kLimit);
            const bool bounds = i >= 4;
            const bool fits =
                interval.lower <= kLevels[k] && (bounds || kLevels[k] <= interval.upper);
            ++limits.checked;
            limits.off += fits ? 0 : 1;
            line += fmt::format(" {:>6}{}", counts[i][k], fits ? ' ' : '!');
        }
        fmt::print("{}\n", line);
    }
    std::fflush(stdout);
}

bool calibrate(const NullOptions &options) {
    fmt::print("{} runs of {} points each; expected at 1e-2, 1e-3, 1e-4: {:g}, {:g}, {:g}.\n"
               "! is out of the binomial 99.9 % limits (\"combined\" and \"as used\": above).\n",
               options.runs, options.samples, 1e-2 * options.runs, 1e-3 * options.runs,
               1e-4 * options.runs);
    Limits limits;
    int warps = 0;
    for (const Configuration &item : rightConfigurations()) {
        if ((item.target->hasParameter && item.a != kAlpha) ||
            item.name.find(options.warp) == std::string::npos) {
            continue;
        }
        ++warps;
        print(item, countRuns(item, options), options.runs, limits);
    }
    // Each count is out of its limits with probability 1e-3 at most: as many as chance allows.
    const statistics::Interval rate = statistics::clopperPearson(
        static_cast<std::uint64_t>(limits.off), static_cast<std::uint64_t>(limits.checked), kLimit);
    const bool good = rate.lower <= kLimit;
    fmt::print("{} warps, {} counts, {} of them out of their limits (by chance alone {:.2g}): "
               "{}\n\n",
               warps, limits.checked, limits.off, kLimit * limits.checked, good ? "ok" : "OFF");
    return good;
}

bool runBatteries(const NullOptions &options) {
    std::vector<Configuration> items = rightConfigurations();
    std::erase_if(items, [&](const Configuration &item) {
        return item.name.find(options.warp) == std::string::npos;
    });
    std::mutex mutex;
    int passed = 0;
    int failed = 0;
    double largest = 0.0;
    std::string largestOf;
    const auto count = static_cast<std::size_t>(items.empty() ? 0 : options.batteries);
    forEach("batteries", count, [&](std::size_t i) {
        const Configuration &item = items[i % items.size()];
        battery::TestOptions test;
        test.parameter = item.a;
        test.seed = statistics::deriveSeed(options.seed, "battery", 0, static_cast<unsigned>(i));
        const battery::TestResult result =
            battery::testWarp(item.warp, item.density, *item.target, test);
        const std::scoped_lock lock(mutex);
        passed += result.passed() ? 1 : 0;
        if (result.verdict == battery::Status::Fail) {
            ++failed;
            fmt::print("{} a = {}: {}", item.name, item.a, battery::explain(result));
        }
        const double part = result.stratified.maxMoment / result.stratified.threshold;
        if (part > largest) {
            largest = part;
            largestOf = fmt::format("{} at a = {}", item.name, item.a);
        }
    });
    fmt::print("{} whole batteries over {} right configurations: {} passed, {} failed, {} cannot "
               "tell; largest smooth moment {:.2f} of its threshold ({})\n",
               count, items.size(), passed, failed, static_cast<int>(count) - passed - failed,
               largest, largestOf);
    return failed == 0;
}

} // namespace

bool runNull(const NullOptions &options) {
    const bool calibrated = options.runs == 0 || calibrate(options);
    return runBatteries(options) && calibrated;
}

} // namespace warp_exam
