// SPDX-License-Identifier: MIT
#pragma once

namespace statistics {

/// What a test of a mean needs to know of a sample.
struct MomentSummary {
    double count = 0.0;
    double mean = 0.0;
    double variance = 0.0;     ///< unbiased (divided by count - 1)
    double thirdCentral = 0.0; ///< unbiased (Fisher's k3)
};

/// Running mean, variance and third central moment, numerically stable and mergeable.
/// \see P. Pébay, "Formulas for robust, one-pass parallel computation of covariances and
///      arbitrary-order statistical moments", Sandia report SAND2008-6212, 2008.
class RunningMoments {
public:
    void add(double value);
    void merge(const RunningMoments &other);

    /// Variance is 0 below 2 values and the third moment 0 below 3.
    [[nodiscard]] MomentSummary summary() const;

private:
    double m_count = 0.0;
    double m_mean = 0.0;
    double m_sum2 = 0.0; ///< sum of squared deviations
    double m_sum3 = 0.0; ///< sum of cubed deviations
};

/// Skewness thirdCentral / variance^1.5; 0 for a sample without variance.
double skewness(const MomentSummary &summary);

} // namespace statistics
