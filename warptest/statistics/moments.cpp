// SPDX-License-Identifier: MIT
#include "moments.h"

#include <cmath>

namespace statistics {

void RunningMoments::add(double value) {
    RunningMoments one;
    one.m_count = 1.0;
    one.m_mean = value;
    merge(one);
}

void RunningMoments::merge(const RunningMoments &other) {
    if (other.m_count == 0.0) {
        return;
    }
    const double a = m_count;
    const double b = other.m_count;
    const double n = a + b;
    const double delta = other.m_mean - m_mean;
    m_sum3 += other.m_sum3 + delta * delta * delta * a * b * (a - b) / (n * n) +
              3.0 * delta * (a * other.m_sum2 - b * m_sum2) / n;
    m_sum2 += other.m_sum2 + delta * delta * a * b / n;
    m_mean += delta * b / n;
    m_count = n;
}

MomentSummary RunningMoments::summary() const {
    MomentSummary result{m_count, m_mean, 0.0, 0.0};
    if (m_count >= 2.0) {
        result.variance = m_sum2 / (m_count - 1.0);
    }
    if (m_count >= 3.0) {
        result.thirdCentral = m_sum3 * m_count / ((m_count - 1.0) * (m_count - 2.0));
    }
    return result;
}

double skewness(const MomentSummary &summary) {
    return summary.variance > 0.0 ? summary.thirdCentral / std::pow(summary.variance, 1.5) : 0.0;
}

} // namespace statistics
