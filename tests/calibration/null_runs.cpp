// SPDX-License-Identifier: MIT
#include <statistics/binomial.h>
#include <statistics/replicates.h>
#include <statistics/tile_welch.h>

#include <boost/math/distributions/normal.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "recording.h"
#include "runs.h"

namespace calibration {

namespace {

using grader::RadianceMoments;
using statistics::MomentSummary;

constexpr int kRepeats = 256; ///< samples per pixel
constexpr int kReference = 3; ///< times as many of the reference
constexpr int kTileSize = 8;
constexpr double kLeast = 1e-3; ///< of a KS test's p-value

/// Kolmogorov's limit law with Stephens' correction for n. \return  p-value of uniformity
double kolmogorovSmirnov(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto n = static_cast<double>(values.size());
    double distance = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto rank = static_cast<double>(i);
        distance = std::max({distance, values[i] - rank / n, (rank + 1) / n - values[i]});
    }
    const double lambda = (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n)) * distance;
    double p = 0;
    for (int k = 1; k <= 100; ++k)
        p += (k % 2 == 1 ? 2 : -2) * std::exp(-2.0 * k * k * lambda * lambda);
    return std::clamp(p, 0.0, 1.0);
}

double twoSided(double z) {
    return 2 * cdf(complement(boost::math::normal(), std::fabs(z)));
}

/// p-values of one statistic over the runs.
struct Series {
    std::vector<double> values;
    int beyondGate = 0;        ///< runs in which the statistic would not be used
    bool conservative = false; ///< may reject less often than its level says
};

using Table = std::map<std::string, Series>;

statistics::MomentImage imageOf(const std::vector<MomentSummary> &pixels) {
    return {kSide, kSide, pixels};
}

void addImage(Table &table, const std::string &name, const RadianceMoments &a,
              const RadianceMoments &b, std::size_t channel) {
    const statistics::TileWelchResult found = statistics::tileWelchTest(
        imageOf(a[channel]), imageOf(b[channel]), {.tileSize = kTileSize});
    const auto tiles = static_cast<double>(found.tiles.size());
    const auto add = [&](const char *what, bool gate, double p) {
        Series &series = table[name + ", " + what];
        if (gate)
            series.values.push_back(p);
        else
            ++series.beyondGate;
    };
    add("global mean", found.global.gateMet, found.global.pValue);
    add("sum of squares", found.gateMet, found.sumPValue);
    // The grader uses Bonferroni's bound; this is the exact p-value for independent tiles.
    const double worst = twoSided(found.tiles[found.worstTile].score);
    add("worst tile", found.gateMet, 1 - std::pow(1 - worst, tiles));
}

std::vector<MomentSummary> flat(const RadianceMoments &moments) {
    std::vector<MomentSummary> result;
    for (std::size_t i = 0; i < kPixels; ++i) {
        for (const auto &channel : moments)
            result.push_back(channel[i]);
    }
    return result;
}

std::vector<MomentSummary> drawFlat(const Recording &recording, int repeats,
                                    statistics::Random &random) {
    return flat(recording.draw(repeats, random));
}

Table measure(const Recording &recording, int runs, statistics::Random &random) {
    Table table;
    for (int run = 0; run < runs; ++run) {
        const std::size_t channel = static_cast<std::size_t>(run) % 3;
        const RadianceMoments student = recording.draw(kRepeats, random);
        const RadianceMoments equal = recording.draw(kRepeats, random);
        const RadianceMoments more = recording.draw(kReference * kRepeats, random);
        addImage(table, "equal samples", student, equal, channel);
        addImage(table, "more samples", student, more, channel);

        const std::vector<double> weights = statistics::noiseWeights(flat(more));
        std::array<std::vector<MomentSummary>, 4> images;
        std::array<std::vector<MomentSummary>, 4> references;
        for (auto &image : images)
            image = drawFlat(recording, kRepeats / 4, random);
        for (auto &reference : references)
            reference = drawFlat(recording, kRepeats / 2, random);
        const std::array<statistics::ImagePair, 2> pairs = {{
            {images[0], references[0], images[1], references[1]},
            {images[2], references[2], images[3], references[3]},
        }};
        // A self-normalised sum of symmetric numbers with heavy tails: never above its level.
        Series &common = table["common error"];
        common.conservative = true;
        common.values.push_back(
            statistics::commonError(pairs, {.channels = 3, .weights = weights}).pValue);
    }
    return table;
}

/// Whether `count` of `runs` agrees with `level`.
bool agrees(std::size_t count, std::size_t runs, double level, bool conservative) {
    const statistics::Interval interval = statistics::clopperPearson(count, runs, 1e-3);
    return interval.lower <= level && (conservative || level <= interval.upper);
}

bool report(const std::string &scene, const Table &table) {
    bool good = true;
    for (const auto &[name, series] : table) {
        const std::size_t runs = series.values.size();
        if (runs == 0) {
            fmt::print("{:<7} {:<32} beyond the gate in all {} runs: not used\n", scene, name,
                       series.beyondGate);
            continue;
        }
        const auto below = [&](double level) {
            return static_cast<std::size_t>(std::count_if(
                series.values.begin(), series.values.end(), [=](double p) { return p <= level; }));
        };
        const double ks = kolmogorovSmirnov(series.values);
        const bool fits = (series.conservative || ks >= kLeast) &&
                          agrees(below(1e-2), runs, 1e-2, series.conservative) &&
                          agrees(below(1e-3), runs, 1e-3, series.conservative);
        good = good && fits;
        fmt::print("{:<7} {:<32} {:>6} {:>6} {:>8.4f} {:>5} ({:>5.1f}) {:>5} ({:>5.1f})  {}\n",
                   scene, name, runs, series.beyondGate, ks, below(1e-2),
                   1e-2 * static_cast<double>(runs), below(1e-3), 1e-3 * static_cast<double>(runs),
                   fits ? "ok" : "OFF");
    }
    return good;
}

} // namespace

const std::vector<std::string> &sceneNames() {
    static const std::vector<std::string> names = {"box", "sky", "table"};
    return names;
}

bool runNull(int runs, std::uint64_t seed) {
    fmt::print("Correct code against itself: {0} x {0} pixels, {1} samples, {2} runs\n"
               "{3:<7} {4:<32} {5:>6} {6:>6} {7:>8} {8:>13} {9:>13}\n",
               kSide, kRepeats, runs, "scene", "statistic", "used", "gated", "KS p",
               "p<=1e-2 (exp)", "p<=1e-3 (exp)");
    bool good = true;
    for (const std::string &scene : sceneNames()) {
        const Recording recording(scene, seed);
        statistics::Random random(statistics::deriveSeed(seed, "null/" + scene));
        good = report(scene, measure(recording, runs, random)) && good;
        std::fflush(stdout);
    }
    return good;
}

} // namespace calibration
