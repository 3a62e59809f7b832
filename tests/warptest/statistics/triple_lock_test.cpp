// SPDX-License-Identifier: MIT
#include <statistics/triple_lock.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using namespace statistics; // NOLINT(google-build-using-namespace): the namespace under test

namespace {

/// A test whose stages have been decided beforehand.
LockResult replay(const std::vector<StageResult> &stages, const LockConfig &config = {}) {
    return tripleLock([&](const StageRequest &request) { return stages.at(request.index); },
                      config);
}

StageResult rejecting(double deviation = 1.0) {
    StageResult result;
    result.pValue = 0.0;
    result.deviation = {deviation};
    return result;
}

} // namespace

TEST(TripleLock, AccusesAfterThreeRejectionsInTheSameDirection) {
    const LockResult result = replay({rejecting(), rejecting(), rejecting()});
    EXPECT_EQ(result.decision, Decision::Fail);
    EXPECT_EQ(result.stages.size(), 3U);
}

TEST(TripleLock, AsksEachStageAtItsLevelAndSize) {
    std::vector<StageRequest> requests;
    tripleLock([&](const StageRequest &request) {
        requests.push_back(request);
        return rejecting();
    });
    ASSERT_EQ(requests.size(), 3U);
    EXPECT_EQ(requests[1].index, 1U);
    EXPECT_EQ(requests[0].significance, 1e-4);
    EXPECT_EQ(requests[2].significance, 1e-5);
    EXPECT_EQ(requests[1].sampleFactor, 4);
    EXPECT_EQ(requests[2].sampleFactor, 16);
}

TEST(TripleLock, DoesNotAccuseWhenTheDirectionTurns) {
    const LockResult result = replay({rejecting(1.0), rejecting(-1.0), rejecting(1.0)});
    EXPECT_EQ(result.decision, Decision::Inconclusive);
    EXPECT_FALSE(result.sameDeviation);
    EXPECT_EQ(result.stages.size(), 2U);
}

TEST(TripleLock, AccusesOfGrossErrorsThatChangeFromRunToRun) {
    const auto gross = [](double direction) {
        StageResult result = rejecting(direction);
        result.z = 12.0;
        result.effect = 0.06;
        return result;
    };
    const LockConfig config{.tolerance = 0.01};
    const LockResult result = replay({gross(1.0), gross(-1.0), gross(1.0)}, config);
    EXPECT_EQ(result.decision, Decision::Fail);
    EXPECT_FALSE(result.sameDeviation);
    StageResult quiet;
    quiet.pValue = 0.5;
    for (const auto &stages : {std::vector<StageResult>{gross(1.0), rejecting(-1.0)},
                               {rejecting(1.0), gross(-1.0)},
                               {gross(1.0), gross(-1.0), rejecting(1.0)},
                               {gross(1.0), gross(-1.0), quiet}})
        EXPECT_NE(replay(stages, config).decision, Decision::Fail);
}

TEST(TripleLock, PassesOnlyWithABoundOfTheError) {
    StageResult quiet;
    quiet.pValue = 0.5;
    quiet.effectBound = 0.01;
    EXPECT_EQ(replay({quiet}, {.passLimit = 0.02}).decision, Decision::Pass);
    EXPECT_EQ(replay({quiet}, {.passLimit = 0.005}).decision, Decision::Inconclusive);
    EXPECT_EQ(replay({rejecting(), quiet}, {.passLimit = 0.02}).decision, Decision::Pass);
}

TEST(TripleLock, NeitherPassesNorFailsOnWhatIsNoNumber) {
    StageResult broken;
    broken.pValue = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(replay({broken}).decision, Decision::Inconclusive);
    StageResult unreliable = rejecting();
    unreliable.reliable = false;
    EXPECT_EQ(replay({unreliable}).decision, Decision::Inconclusive);
}

TEST(TripleLock, ConfirmsAGrossErrorWithSmallerSamples) {
    StageResult gross = rejecting();
    gross.z = 12.0;
    gross.effect = 0.06;
    const LockConfig config{.tolerance = 0.01};
    const auto factorsOf = [&](const StageResult &first) {
        std::vector<int> factors;
        const LockResult result = tripleLock(
            [&](const StageRequest &request) {
                factors.push_back(request.sampleFactor);
                return request.index == 0 ? first : rejecting();
            },
            config);
        EXPECT_EQ(result.decision, Decision::Fail);
        return factors;
    };
    EXPECT_EQ(factorsOf(gross), (std::vector<int>{1, 1, 4}));
    gross.effect = 0.04; // as certain, but small
    EXPECT_EQ(factorsOf(gross), (std::vector<int>{1, 4, 16}));
    StageResult quiet;
    quiet.pValue = 0.5;
    gross.effect = 0.06;
    EXPECT_EQ(replay({gross, rejecting(), quiet}, config).decision, Decision::Pass)
        << "three must agree on what is gross, too";
}

TEST(DeviationAgreement, IsTheCosine) {
    EXPECT_DOUBLE_EQ(deviationAgreement({1.0, 0.0}, {1.0, 1.0}), 1.0 / std::sqrt(2.0));
    EXPECT_EQ(deviationAgreement({}, {}), 1.0);
    EXPECT_EQ(deviationAgreement({1.0}, {}), 0.0);
    EXPECT_EQ(deviationAgreement({0.0}, {1.0}), 0.0);
}
