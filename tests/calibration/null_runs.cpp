// SPDX-License-Identifier: MIT
#include <statistics/binomial.h>
#include <statistics/replicates.h>
#include <statistics/tile_welch.h>

#include <boost/math/distributions/normal.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <map>

#include "recording.h"
#include "runs.h"

namespace calibration {

namespace {

using grader::RadianceMoments;
using statistics::MomentSummary;

constexpr int kRepeats = 256; ///< samples per pixel, or more where the gate asks for them
constexpr int kMostRepeats = 4096;
constexpr int kPilotRuns = 40;
constexpr int kReference = 3;   ///< times as many of the reference
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
    int beyondGate = 0; ///< runs in which the statistic would not be used

    void add(bool gate, double p) {
        if (gate)
            values.push_back(p);
        else
            ++beyondGate;
    }
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
        table[name + ", " + what].add(gate, p);
    };
    add("global mean", found.global.gateMet, found.global.pValue);
    add("sum of squares", found.gateMet, found.sumPValue);
    // The grader uses Bonferroni's bound; this is the exact p-value for independent tiles.
    const double worst = twoSided(found.tiles[found.worstTile].score);
    add("worst tile", found.gateMet, 1 - std::pow(1 - worst, tiles));
}

/// The worst of pixels that are looked at again with many samples: the exact p-value for
/// independent ones, where the grader uses Bonferroni's bound.
void addPixels(Table &table, const Recording &recording, std::size_t channel,
               statistics::Random &random) {
    constexpr int kPixelsAgain = 16;
    constexpr std::uint32_t kSamplesAgain = 1 << 14;
    std::vector<float> pixels;
    while (pixels.size() < kPixelsAgain)
        pixels.push_back(static_cast<float>(random.nextBelow(kPixels)));
    std::array<std::vector<MomentSummary>, 2> sides;
    for (auto &side : sides) {
        const std::vector<float> values = recording.samples(pixels, kSamplesAgain, random);
        for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) {
            statistics::RunningMoments moments;
            for (std::size_t i = 0; i < kSamplesAgain; ++i)
                moments.add(static_cast<double>(values[3 * (pixel * kSamplesAgain + i) + channel]));
            side.push_back(moments.summary());
        }
    }
    double worst = 1;
    double tested = 0;
    for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) {
        const statistics::MeanTestResult test =
            statistics::welchTest(sides[0][pixel], sides[1][pixel]);
        // One that is always black or always seen in the light itself says nothing.
        if (!test.gateMet || !(test.standardError > 0))
            continue;
        ++tested;
        worst = std::min(worst, test.pValue);
    }
    table["worst of single pixels"].add(tested > 0, 1 - std::pow(1 - worst, tested));
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

/// Samples per pixel with which the statistics are used: the grader, too, takes more where the
/// skewness gate is not met.
int repeatsFor(const Recording &recording, statistics::Random &random) {
    for (int repeats = kRepeats; repeats < kMostRepeats; repeats *= 2) {
        int beyond = 0;
        for (int run = 0; run < kPilotRuns; ++run) {
            const RadianceMoments student = recording.draw(repeats, random);
            const RadianceMoments more = recording.draw(kReference * repeats, random);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto found = statistics::tileWelchTest(imageOf(student[c]), imageOf(more[c]),
                                                             {.tileSize = kTileSize});
                beyond += found.gateMet ? 0 : 1;
            }
        }
        if (20 * beyond <= 3 * kPilotRuns)
            return repeats;
    }
    return kMostRepeats;
}

Table measure(const Recording &recording, int repeats, int runs, statistics::Random &random) {
    Table table;
    for (int run = 0; run < runs; ++run) {
        const std::size_t channel = static_cast<std::size_t>(run) % 3;
        const RadianceMoments student = recording.draw(repeats, random);
        const RadianceMoments equal = recording.draw(repeats, random);
        const RadianceMoments more = recording.draw(kReference * repeats, random);
        addImage(table, "equal samples", student, equal, channel);
        addImage(table, "more samples", student, more, channel);
        addPixels(table, recording, channel, random);

        const std::vector<double> weights = statistics::noiseWeights(flat(more));
        table["squared error"].add(true,
                                   statistics::errorPValue(flat(student), flat(equal), flat(more),
                                                           {.channels = 3, .weights = weights}));
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
        table["common error"].add(
            true, statistics::commonError(pairs, {.channels = 3, .weights = weights}).pValue);
    }
    return table;
}

/// Whether `count` of `runs` agrees with `level`.
bool agrees(std::size_t count, std::size_t runs, double level) {
    const statistics::Interval interval = statistics::clopperPearson(count, runs, 1e-3);
    return interval.lower <= level && level <= interval.upper;
}

bool report(const std::string &scene, int repeats, const Table &table) {
    bool good = true;
    for (const auto &[name, series] : table) {
        const std::size_t runs = series.values.size();
        const auto below = [&](double level) {
            return static_cast<std::size_t>(std::count_if(
                series.values.begin(), series.values.end(), [=](double p) { return p <= level; }));
        };
        const double ks = runs > 0 ? kolmogorovSmirnov(series.values) : 0;
        // What is seldom used at these samples is not calibrated by them.
        const bool fits = static_cast<std::size_t>(series.beyondGate) * 9 <= runs && ks >= kLeast &&
                          agrees(below(1e-2), runs, 1e-2) && agrees(below(1e-3), runs, 1e-3);
        good = good && fits;
        fmt::print("{:<7} {:>5} {:<30} {:>6} {:>6} {:>8.4f} {:>5} ({:>5.1f}) {:>5} ({:>5.1f})  "
                   "{}\n",
                   scene, repeats, name, runs, series.beyondGate, ks, below(1e-2),
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
    fmt::print("Correct code against itself: {0} x {0} pixels, {1} runs\n"
               "{2:<7} {3:>5} {4:<30} {5:>6} {6:>6} {7:>8} {8:>13} {9:>13}\n",
               kSide, runs, "scene", "spp", "statistic", "used", "gated", "KS p", "p<=1e-2 (exp)",
               "p<=1e-3 (exp)");

    struct Result {
        int repeats;
        Table table;
    };

    // Recorded one after another, as that happens in a working folder of its own.
    std::vector<Recording> recordings;
    for (const std::string &scene : sceneNames())
        recordings.emplace_back(scene, seed);
    std::vector<std::future<Result>> results;
    for (std::size_t i = 0; i < recordings.size(); ++i) {
        results.push_back(std::async(std::launch::async, [&, i] {
            statistics::Random random(statistics::deriveSeed(seed, "null/" + sceneNames()[i]));
            const int repeats = repeatsFor(recordings[i], random);
            return Result{repeats, measure(recordings[i], repeats, runs, random)};
        }));
    }
    bool good = true;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Result result = results[i].get();
        good = report(sceneNames()[i], result.repeats, result.table) && good;
        std::fflush(stdout);
    }
    return good;
}

} // namespace calibration
