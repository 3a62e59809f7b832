// SPDX-License-Identifier: MIT
#include <catalog/warp_catalog.h>
#include <support/probe_child.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using protocol::Op;

constexpr char kProbe[] = NORI_PROBE_REFERENCE;

protocol::Request warpRequest(Op op, std::string_view id, std::vector<float> values,
                              double parameter = 0) {
    protocol::Request request;
    request.op = op;
    request.text = id;
    request.parameter = static_cast<float>(parameter);
    request.values = std::move(values);
    return request;
}

/// Midpoints of an 8 x 8 grid, row by row.
std::vector<float> gridSamples() {
    std::vector<float> samples;
    for (int i = 0; i < 64; ++i) {
        samples.push_back(static_cast<float>(i % 8) / 8.0F + 1.0F / 16.0F);
        samples.push_back(static_cast<float>(i / 8) / 8.0F + 1.0F / 16.0F); // NOLINT: row number
    }
    return samples;
}

TEST(WarpProbe, AnswersEachSampleInItsOrder) {
    const std::vector<float> samples = gridSamples();
    const protocol::RequestGroup group{{}, {warpRequest(Op::WarpSample, "square", samples)}};
    EXPECT_EQ(test::runProbe(kProbe, group).responses.at(0).values, samples);
}

TEST(WarpProbe, GivesPointsInsideAndTheTrueDensityForEveryWarpOfTheCatalogue) {
    for (const catalog::WarpEntry &entry : catalog::warpCatalog()) {
        const double a = entry.parameters.back();
        protocol::RequestGroup group{{}, {warpRequest(Op::WarpSample, entry.id, gridSamples(), a)}};
        const std::vector<float> points = test::runProbe(kProbe, group).responses.at(0).values;
        const auto dimension = static_cast<std::size_t>(entry.dimension);
        ASSERT_EQ(points.size(), 64 * dimension) << entry.id;
        group.requests = {warpRequest(Op::WarpDensity, entry.id, points, a)};
        const std::vector<float> densities = test::runProbe(kProbe, group).responses.at(0).values;
        ASSERT_EQ(densities.size(), 64U) << entry.id;
        for (std::size_t i = 0; i < 64; ++i) {
            const float *x = &points[i * dimension];
            const catalog::Point p{x[0], x[1], dimension == 3 ? x[2] : 0.0F};
            EXPECT_EQ(catalog::placement(entry, p), catalog::Placement::Inside) << entry.id;
            const double expected = entry.density(p, a);
            EXPECT_NEAR(static_cast<double>(densities[i]), expected, 1e-4 * expected) << entry.id;
        }
    }
}

TEST(WarpProbe, PassesTheParameterOn) {
    // At its pole, Beckmann's density is 1 / (pi a^2).
    protocol::RequestGroup group;
    for (const double a : {0.1, 0.5})
        group.requests.push_back(warpRequest(Op::WarpDensity, "beckmann", {0, 0, 1}, a));
    const test::ProbeRun run = test::runProbe(kProbe, group);
    EXPECT_NEAR(run.responses.at(0).values.at(0), 1 / (M_PI * 0.01), 1e-2);
    EXPECT_NEAR(run.responses.at(1).values.at(0), 1 / (M_PI * 0.25), 1e-4);
}

TEST(WarpProbe, GivesZeroOutsideTheSupport) {
    const protocol::RequestGroup group{
        {}, {warpRequest(Op::WarpDensity, "disk", {0.9F, 0.9F, 0.1F, 0.2F})}};
    const std::vector<float> densities = test::runProbe(kProbe, group).responses.at(0).values;
    EXPECT_EQ(densities.at(0), 0.0F);
    EXPECT_NEAR(densities.at(1), 1 / M_PI, 1e-6);
}

} // namespace
