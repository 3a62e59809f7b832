// SPDX-License-Identifier: MIT
#pragma once

#include <statistics/moments.h>

namespace statistics {

/// The largest |skewness of the mean| at which Hall's transform keeps its level
/// (inflation at most 1.5 at a level of 1e-4).
inline constexpr double kSkewnessGate = 0.1;

/// Two-sided test of a difference of means.
struct MeanTestResult {
    double difference = 0.0; ///< estimate minus target, or first mean minus second
    double standardError = 0.0;
    double degreesOfFreedom = 0.0; ///< Welch-Satterthwaite for two samples
    double meanSkewness = 0.0;     ///< skewness g of the law of `difference`
    double z = 0.0;                ///< difference / standardError; 0 without variance
    double hall = 0.0;             ///< z after Hall's transform
    double pValuePlain = 1.0;      ///< Student's or Welch's t
    double pValue = 1.0;           ///< from `hall`; 0 for a difference without variance
    bool gateMet = true;           ///< |g| <= kSkewnessGate: `pValue` can be relied on
};

/// Hall's transform h = z + g z^2/3 + g^2 z^3/27 + g/6, which takes the skewness g of the mean out
/// of a Studentised statistic. Monotone in z.
/// \see P. Hall, "On the removal of skewness by transformation", J. R. Stat. Soc. B 54, 1992.
double hallTransform(double z, double meanSkewness);

/// The test for an estimated difference whose variance and third central moment are known (those
/// of the estimate, not of single samples).
MeanTestResult meanTest(double difference, double variance, double thirdCentral,
                        double degreesOfFreedom);

/// Student's one-sample test of `sample.mean == target`.
/// \throws std::invalid_argument  below 2 samples.
MeanTestResult oneSampleTest(const MomentSummary &sample, double target);

/// Welch's test of equal means without the assumption of equal variances.
/// \throws std::invalid_argument  below 2 samples on a side.
MeanTestResult welchTest(const MomentSummary &a, const MomentSummary &b);

/// Upper confidence bound (at 1 - `level`) of |true difference|. A pass needs it below the
/// tolerance: "not significant" alone is no evidence of being right.
double absoluteDifferenceBound(const MeanTestResult &test, double level = 1e-4);

/// Minimal detectable difference at two-sided `significance` and `power`, in units of
/// `standardError`'s.
double detectableDifference(double standardError, double significance = 1e-4, double power = 0.999);

} // namespace statistics
