// SPDX-License-Identifier: MIT
#include <nori/rfilter.h>

#include <gtest/gtest.h>

#include "fixtures.h"

namespace nori {
namespace {

TEST(ReconstructionFilter, EvaluatesTheGaussianShiftedToZero) {
    const auto filter = test::make<ReconstructionFilter>("gaussian");
    EXPECT_EQ(filter->getRadius(), 2.0f);
    EXPECT_NEAR(filter->eval(0.0f), 1.0f - std::exp(-8.0f), 1e-6f); // r^2 / (2 stddev^2) = 8
    EXPECT_NEAR(filter->eval(0.5f), std::exp(-0.5f) - std::exp(-8.0f), 1e-6f);
    EXPECT_EQ(filter->eval(2.0f), 0.0f);
}

TEST(ReconstructionFilter, EvaluatesMitchellAtItsKnots) {
    const auto filter = test::make<ReconstructionFilter>("mitchell");
    // B = C = 1/3: 8/9 at 0, 1/18 at 1, 0 at 2 (Mitchell and Netravali 1988)
    EXPECT_NEAR(filter->eval(0.0f), 8.0f / 9.0f, 1e-6f);
    EXPECT_NEAR(filter->eval(1.0f), 1.0f / 18.0f, 1e-6f);
    EXPECT_NEAR(filter->eval(-2.0f), 0.0f, 1e-6f);
    EXPECT_LT(filter->eval(1.5f), 0.0f);
}

TEST(ReconstructionFilter, EvaluatesTentAndBox) {
    EXPECT_EQ(test::make<ReconstructionFilter>("tent")->eval(-0.25f), 0.75f);
    EXPECT_EQ(test::make<ReconstructionFilter>("tent")->getRadius(), 1.0f);
    EXPECT_EQ(test::make<ReconstructionFilter>("box")->eval(0.4f), 1.0f);
    EXPECT_EQ(test::make<ReconstructionFilter>("box")->getRadius(), 0.5f);
}

TEST(ReconstructionFilter, RefusesARadiusThatIsNotPositive) {
    for (const float radius : {0.0f, -1.0f, NAN}) {
        PropertyList props;
        props.setFloat("radius", radius);
        EXPECT_THROW(test::make<ReconstructionFilter>("gaussian", props), NoriException) << radius;
    }
}

} // namespace
} // namespace nori
