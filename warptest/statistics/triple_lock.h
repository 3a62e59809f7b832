// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace statistics {

/// Verdict of a test. Pass: right within the tolerance. Fail: wrong, confirmed by fresh random
/// numbers. Inconclusive: the data cannot tell.
enum class Decision { Pass, Fail, Inconclusive };

/// What a stage is asked to do.
struct StageRequest {
    unsigned index = 0;        ///< 0, 1, 2: goes into deriveSeed(), so that stages are independent
    double significance = 0.0; ///< level at which this stage rejects
    int sampleFactor = 1;      ///< times the samples of stage 0
};

/// What a stage has found.
struct StageResult {
    double pValue = 1.0; ///< at most `significance` rejects
    double effect = 0.0; ///< size of the error, in the unit of LockConfig::tolerance
    /// Upper confidence bound of the size of the error: a pass needs it below the pass limit.
    double effectBound = std::numeric_limits<double>::infinity();
    double mde = 0.0; ///< minimal detectable error of this stage, for the report
    double z = 0.0;   ///< standardised deviation, LockConfig::grossZ; 0 if there is none
    /// Where and in which direction: signed deviations of a fixed shape, the same in all stages
    /// (one number for a mean, cell or tile deviations for a map). Empty: not compared.
    std::vector<double> deviation;
    /// False when the test's own preconditions do not hold (skewness gate): ends Inconclusive.
    bool reliable = true;
};

struct LockConfig {
    double tolerance = 0.0; ///< effect beyond which an error is gross is 5 times this
    /// A pass needs effectBound <= this; infinity: not being rejected is enough.
    double passLimit = std::numeric_limits<double>::infinity();
    std::array<double, 3> significance{1e-4, 1e-4, 1e-5};
    std::array<int, 3> sampleFactor{1, 4, 16};
    /// From this z on a gross error is confirmed with the samples of stages 0 and 1 instead of 1
    /// and 2: it is known sooner, and just as certainly.
    double grossZ = 12.0;
    /// Smallest cosine between two stages' deviations that counts as "the same place". Independent
    /// noise in 1023 cells gives 0 +- 0.03, an error that is just detectable 0.25 or more.
    double minAgreement = 0.1;
};

struct LockResult {
    Decision decision = Decision::Inconclusive;
    std::vector<StageResult> stages; ///< all that were run; the last one decided
    bool sameDeviation = true;       ///< false: stages rejected, but in different places
};

/// Cosine of the angle between two deviations; 1 if either is empty or both are zero.
inline double deviationAgreement(const std::vector<double> &a, const std::vector<double> &b) {
    if (a.empty() || a.size() != b.size()) {
        return a.size() == b.size() ? 1.0 : 0.0;
    }
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += a[i] * b[i];
        aa += a[i] * a[i];
        bb += b[i] * b[i];
    }
    if (aa == 0.0 || bb == 0.0) {
        return aa == bb ? 1.0 : 0.0;
    }
    return ab / std::sqrt(aa * bb);
}

/// Accuses only when three tests on fresh random numbers reject alike. With the default levels a
/// correct program is accused with probability 1e-13; over 45,000 decisions of a course, with
/// levels three times inflated, 1.2e-7. Correct programs mostly end after the cheap first stage.
///
/// A stage that does not reject ends the test: Pass if its bound of the error is within the
/// pass limit, else Inconclusive. An unreliable stage, or one that rejects in another place than
/// the one before, ends it Inconclusive; but where both errors are gross, no noise makes them, and
/// it is the program that is another one each time it starts.
///
/// \param stage   Called as StageResult(const StageRequest &), at most 3 times.
template <typename Stage>
LockResult tripleLock(Stage &&stage, const LockConfig &config = {}) {
    LockResult result;
    std::size_t smaller = 0; // 1 once the error is gross
    bool wasGross = false;   // in the stage before
    for (std::size_t i = 0; i < config.significance.size(); ++i) {
        const StageRequest request{static_cast<unsigned>(i), config.significance[i],
                                   config.sampleFactor[i - smaller]};
        result.stages.push_back(stage(request));
        const StageResult &found = result.stages.back();
        if (!found.reliable) {
            return result;
        }
        if (!(found.pValue <= request.significance)) {
            // `not <=` on the p-value: one that is not a number never accuses, nor does it pass.
            const bool passes =
                found.pValue > request.significance && found.effectBound <= config.passLimit;
            result.decision = passes ? Decision::Pass : Decision::Inconclusive;
            return result;
        }
        const bool gross =
            std::fabs(found.z) >= config.grossZ && std::fabs(found.effect) > 5.0 * config.tolerance;
        if (i > 0 && deviationAgreement(result.stages[i - 1].deviation, found.deviation) <
                         config.minAgreement) {
            result.sameDeviation = false;
            if (!gross || !wasGross) {
                return result;
            }
        }
        if (i == 0 && gross) {
            smaller = 1;
        }
        wasGross = gross;
    }
    result.decision = Decision::Fail;
    return result;
}

} // namespace statistics
