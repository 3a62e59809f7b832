// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>
#include <grader/rubric/rubric.h>

#include <vector>

namespace grader {

/// Fraction of a check's weight that is kept [0, 1].
///
/// Pass keeps all; Inconclusive too, since a point is lost only with proof; Infra and Human never
/// cost. Fail costs by effect: nothing up to the tolerance, all from `gross` on, log-linear in
/// between, all where the effect is unknown. Missing, BuildError, Crash and Timeout cost all.
///
/// \param floor  effect that every seed finds, NaN if there is no noise: takes the place of a
///               smaller tolerance, so that points do not hang on the seed
double checkScore(const RubricCheck &rule, Verdict verdict, double effect,
                  double floor = kNoNumber);

/// The worse of two verdicts of one item. From the worst: missing, build_error, crash, timeout,
/// fail (something is proven), then human, infra, inconclusive, pass.
Verdict worseVerdict(Verdict a, Verdict b);

/// Points of one item.
///
///     kept = sum(weight * score) / sum(weight)                over visible checks
///          - min(latentFraction, sum(weight * (1 - score)) / sum(visible weight))  over latent
///          ones
///
/// held between 0 and the least keeps + (1 - keeps) * score of a check; blemishes do not enter. A
/// check without an outcome counts as Infra.
///
/// \param outcomes  in any order; those of other items are passed over
ItemResult scoreItem(const RubricItem &item, const std::vector<CheckResult> &outcomes);

/// Adds up under the rubric's policy for extras; exact in hundredths.
double totalPoints(const Rubric &rubric, const std::vector<ItemResult> &items);

/// Fills in `items`, `total` and `cap`.
/// \param rubric  after resolveChecks()
void score(const Rubric &rubric, const std::vector<CheckResult> &outcomes,
           SubmissionResult &result);

/// Fills in the same for a hand-in that could not be tested at all: no points are decided.
/// \param verdict  Human if it could not be read, Infra if we failed
void scoreUntested(const Rubric &rubric, Verdict verdict, const std::string &reason,
                   SubmissionResult &result);

} // namespace grader
