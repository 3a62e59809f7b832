// SPDX-License-Identifier: MIT
#include <battery/distribution.h>
#include <battery/inputs.h>
#include <catalog/warp_catalog.h>
#include <statistics/chi_square.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "sample_warps.h"

// Size of the distribution test under the null, over all right warps (but the imprecise one, whose
// error is real) at all parameters. The tolerance zone only makes the test more conservative, so
// the plain p-values of the same statistics are judged here.
TEST(NullSize, IsTheNominalOne) {
    constexpr std::size_t kSamples = std::size_t{1} << 13U;
    constexpr unsigned kRuns = 200;
    int runs = 0;
    int rejectedPlain = 0;
    int rejected = 0;
    for (const auto &sample : sample_warps::kRight) {
        if (sample.name == "sine_from_cosine") {
            continue;
        }
        const auto &entry = catalog::requireWarp(sample.warpId);
        for (const double a : entry.parameters) {
            for (unsigned run = 0; run < kRuns; ++run) {
                const auto inputs = battery::randomInputs(
                    kSamples, statistics::deriveSeed(77, sample.name, 0, run));
                const auto result =
                    battery::judgeDistribution(entry, a, sample_warps::run(sample, inputs, a));
                double smallest = 1.0;
                for (const auto &test : result.tests) {
                    smallest = std::min(smallest,
                                        statistics::toleranceZonePValue(
                                            test.statistic, test.degreesOfFreedom, kSamples, 0.0));
                }
                ++runs;
                rejectedPlain += 4.0 * smallest < 0.01 ? 1 : 0;
                rejected += result.pValue < 0.01 ? 1 : 0;
            }
        }
    }
    // Bonferroni makes 0.01 an upper bound of the level. Runs of one name share their inputs over
    // the parameters, so the rejections come in groups: five standard deviations for groups of 5.
    const double expected = 0.01 * runs;
    EXPECT_LT(rejectedPlain, expected + 5.0 * std::sqrt(5.0 * expected)) << runs << " runs";
    EXPECT_GT(rejectedPlain, expected / 4.0) << "too few: the test has no power";
    EXPECT_LE(rejected, rejectedPlain);
    RecordProperty("runs", runs);
    RecordProperty("rejected", rejectedPlain);
}
