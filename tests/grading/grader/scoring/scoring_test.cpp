// SPDX-License-Identifier: MIT
#include <grader/scoring/points.h>
#include <grader/scoring/scoring.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace grader {
namespace {

constexpr Verdict kVerdicts[] = {Verdict::Pass,    Verdict::Fail,       Verdict::Inconclusive,
                                 Verdict::Missing, Verdict::BuildError, Verdict::Crash,
                                 Verdict::Timeout, Verdict::Infra,      Verdict::Human};

RubricCheck rule(const std::string &id, Severity severity = Severity::Visible, double weight = 1) {
    RubricCheck check;
    check.id = id;
    check.severity = severity;
    check.weight = weight;
    check.tolerance = 0.01;
    check.gross = 1;
    return check;
}

CheckResult outcome(const std::string &id, Verdict verdict, double effect = kNoNumber) {
    CheckResult check;
    check.id = id;
    check.verdict = verdict;
    check.effect = effect;
    check.message = "About " + id + ".";
    return check;
}

RubricItem itemWith(std::vector<RubricCheck> checks) {
    RubricItem item;
    item.id = "item";
    item.points = 10;
    item.checks = std::move(checks);
    return item;
}

TEST(CheckScore, FallsLogLinearlyFromToleranceToGross) {
    const RubricCheck check = rule("a");
    EXPECT_EQ(checkScore(check, Verdict::Fail, 0.005), 1);
    EXPECT_EQ(checkScore(check, Verdict::Fail, 0.01), 1);
    EXPECT_NEAR(checkScore(check, Verdict::Fail, 0.1), 0.5, 1e-12);
    EXPECT_NEAR(checkScore(check, Verdict::Fail, -0.1), 0.5, 1e-12);
    EXPECT_EQ(checkScore(check, Verdict::Fail, 1), 0);
    EXPECT_EQ(checkScore(check, Verdict::Fail, 100), 0);
    EXPECT_EQ(checkScore(check, Verdict::Fail, INFINITY), 0);
    EXPECT_EQ(checkScore(check, Verdict::Fail, kNoNumber), 0);
}

TEST(CheckScore, StartsToFallWhereEverySeedFindsTheError) {
    const RubricCheck check = rule("a"); // 0.01 to 1
    EXPECT_EQ(checkScore(check, Verdict::Fail, 0.05, 0.1), 1) << "only some seeds find it";
    EXPECT_EQ(checkScore(check, Verdict::Fail, 0.1, 0.1), 1);
    EXPECT_NEAR(checkScore(check, Verdict::Fail, 0.1001, 0.1), 1, 1e-3) << "no jump";
    EXPECT_NEAR(checkScore(check, Verdict::Fail, std::sqrt(0.1), 0.1), 0.5, 1e-12);
    EXPECT_EQ(checkScore(check, Verdict::Fail, 1, 0.1), 0) << "gross is gross";
    EXPECT_NEAR(checkScore(check, Verdict::Fail, 0.1, 0.001), 0.5, 1e-12) << "the tolerance counts";
    EXPECT_EQ(checkScore(check, Verdict::Fail, 2, 5), 0);
    EXPECT_EQ(checkScore(check, Verdict::Timeout, 0, 0.1), 0);
}

TEST(CheckScore, IsAllOrNothingWithoutBounds) {
    RubricCheck check = rule("a");
    check.tolerance = check.gross = 0;
    EXPECT_EQ(checkScore(check, Verdict::Fail, 1e-9), 0);
    EXPECT_EQ(checkScore(check, Verdict::Fail, 0), 1);
}

TEST(CheckScore, LosesNothingWithoutProof) {
    for (const Verdict verdict :
         {Verdict::Pass, Verdict::Inconclusive, Verdict::Infra, Verdict::Human})
        EXPECT_EQ(checkScore(rule("a"), verdict, 5), 1) << verdictName(verdict);
    for (const Verdict verdict :
         {Verdict::Missing, Verdict::BuildError, Verdict::Crash, Verdict::Timeout})
        EXPECT_EQ(checkScore(rule("a"), verdict, 0), 0) << verdictName(verdict);
}

TEST(ScoreItem, WeighsItsVisibleChecks) {
    const RubricItem item = itemWith({rule("a", Severity::Visible, 3), rule("b")});
    EXPECT_EQ(scoreItem(item, {outcome("a", Verdict::Pass), outcome("b", Verdict::Fail)}).points,
              7.5);
    EXPECT_EQ(scoreItem(item, {outcome("b", Verdict::Pass), outcome("a", Verdict::Fail)}).points,
              2.5);
}

TEST(ScoreItem, CostsNothingForABlemish) {
    const RubricItem item = itemWith({rule("a"), rule("b", Severity::Blemish)});
    const ItemResult result =
        scoreItem(item, {outcome("a", Verdict::Pass), outcome("b", Verdict::Fail)});
    EXPECT_EQ(result.points, 10);
    EXPECT_EQ(result.verdict, Verdict::Pass);
    EXPECT_EQ(result.reason, "Right in everything that was tested. 1 remark, which costs nothing.");
}

TEST(ScoreItem, CostsAtMostTheLatentFractionForLatentDefects) {
    const RubricItem item =
        itemWith({rule("a"), rule("b"), rule("c", Severity::Latent), rule("d", Severity::Latent),
                  rule("e", Severity::Latent, 0.2)});
    const std::vector<CheckResult> right = {
        outcome("a", Verdict::Pass), outcome("b", Verdict::Pass), outcome("c", Verdict::Pass),
        outcome("d", Verdict::Pass), outcome("e", Verdict::Pass)};
    std::vector<CheckResult> small = right;
    small[4].verdict = Verdict::Fail;
    EXPECT_EQ(scoreItem(item, small).points, 9);
    std::vector<CheckResult> all = small;
    all[2].verdict = all[3].verdict = Verdict::Crash;
    EXPECT_EQ(scoreItem(item, all).points, 7.5);
}

TEST(ScoreItem, KeepsNoMoreThanARequiredCheckDoes) {
    RubricItem item = itemWith({rule("a"), rule("b"), rule("c")});
    item.checks[0].keeps = 0;
    const ItemResult result =
        scoreItem(item, {outcome("a", Verdict::Missing), outcome("b", Verdict::Pass),
                         outcome("c", Verdict::Pass)});
    EXPECT_EQ(result.points, 0);
    EXPECT_EQ(result.verdict, Verdict::Missing);
}

TEST(ScoreItem, KeepsAtMostAFractionWhereACoreCheckFails) {
    RubricItem item = itemWith({rule("a"), rule("b"), rule("c"), rule("d"), rule("e")});
    item.checks[0].keeps = 0.6;
    std::vector<CheckResult> outcomes = {outcome("a", Verdict::Fail, 5),
                                         outcome("b", Verdict::Pass), outcome("c", Verdict::Pass),
                                         outcome("d", Verdict::Pass), outcome("e", Verdict::Pass)};
    EXPECT_EQ(scoreItem(item, outcomes).points, 0.6 * item.points);
    outcomes[0] = outcome("a", Verdict::Pass);
    EXPECT_EQ(scoreItem(item, outcomes).points, item.points);
    for (std::size_t i = 1; i < 4; ++i)
        outcomes[i] = outcome(std::string(1, static_cast<char>('a' + i)), Verdict::Fail, 5);
    EXPECT_EQ(scoreItem(item, outcomes).points, 0.4 * item.points); // without a ceiling: by weight
}

TEST(ScoreItem, SaysWhatWasLostMost) {
    const RubricItem item = itemWith({rule("a"), rule("b"), rule("c", Severity::Latent)});
    std::vector<CheckResult> outcomes = {outcome("a", Verdict::Fail, 0.02),
                                         outcome("b", Verdict::Fail, 0.9),
                                         outcome("c", Verdict::Fail, 5)};
    outcomes[1].diagnoses = {{"mesh.pdf_zero"}};
    EXPECT_EQ(scoreItem(item, outcomes).reason, "About b. Mesh::pdf returns 0. And 2 checks more.");
}

TEST(ScoreItem, NamesBothFilesThatAreMissing) {
    const RubricItem item = itemWith({rule("a"), rule("b"), rule("c")});
    std::vector<CheckResult> outcomes = {outcome("a", Verdict::BuildError),
                                         outcome("b", Verdict::Missing),
                                         outcome("c", Verdict::Missing)};
    outcomes[0].message = "mesh.cpp does not compile";
    outcomes[1].message = outcomes[2].message = "area.cpp was not handed in.";
    EXPECT_EQ(scoreItem(item, outcomes).reason,
              "mesh.cpp does not compile. area.cpp was not handed in.");
}

TEST(ScoreItem, CountsACheckWithoutOutcomeAsOurFailure) {
    const ItemResult result =
        scoreItem(itemWith({rule("a"), rule("b")}), {outcome("a", Verdict::Pass)});
    EXPECT_EQ(result.points, 10);
    EXPECT_EQ(result.verdict, Verdict::Infra);
    EXPECT_EQ(result.checks[1].message, "This check was not run.");
}

TEST(ScoreItem, SaysThatItCannotTell) {
    const ItemResult result =
        scoreItem(itemWith({rule("a")}), {outcome("a", Verdict::Inconclusive)});
    EXPECT_EQ(result.points, 10);
    EXPECT_EQ(result.verdict, Verdict::Inconclusive);
    EXPECT_EQ(result.reason, "Cannot be told, and so costs nothing: About a.");
}

TEST(WorseVerdict, IsAnOrder) {
    for (const Verdict a : kVerdicts) {
        EXPECT_EQ(worseVerdict(a, a), a);
        EXPECT_EQ(worseVerdict(a, Verdict::Pass), a);
        for (const Verdict b : kVerdicts) {
            EXPECT_EQ(worseVerdict(a, b), worseVerdict(b, a));
            for (const Verdict c : kVerdicts)
                EXPECT_EQ(worseVerdict(worseVerdict(a, b), c), worseVerdict(a, worseVerdict(b, c)));
        }
    }
    EXPECT_EQ(worseVerdict(Verdict::Infra, Verdict::Fail), Verdict::Fail);
    EXPECT_EQ(worseVerdict(Verdict::Infra, Verdict::Inconclusive), Verdict::Infra);
}

TEST(TotalPoints, GivesAHundredForEverything) {
    Rubric rubric;
    std::vector<ItemResult> items(2);
    items[0].points = 90;
    items[1].points = 30;
    items[1].extra = true;
    EXPECT_EQ(totalPoints(rubric, items), 100);
    rubric.extras = ExtrasPolicy::OverCap;
    EXPECT_EQ(totalPoints(rubric, items), 120);
    rubric.extras = ExtrasPolicy::Ignore;
    EXPECT_EQ(totalPoints(rubric, items), 90);
}

TEST(TotalPoints, DoesNotDependOnTheOrderOfItems) {
    Rubric rubric;
    rubric.cap = 1000;
    std::vector<ItemResult> items(300);
    for (std::size_t i = 0; i < items.size(); ++i)
        items[i].points = i % 3 == 0 ? 0.1 : 0.01 * static_cast<double>(i % 7);
    const double total = totalPoints(rubric, items);
    std::reverse(items.begin(), items.end());
    EXPECT_EQ(totalPoints(rubric, items), total);
}

TEST(FormatPoints, ShowsAtMostTwoDecimals) {
    EXPECT_EQ(formatPoints(100), "100");
    EXPECT_EQ(formatPoints(7.5), "7.5");
    EXPECT_EQ(formatPoints(7.25), "7.25");
    EXPECT_EQ(formatPoints(0.05), "0.05");
    EXPECT_EQ(formatPoints(0), "0");
    EXPECT_EQ(formatPoints(-1.5), "-1.5");
}

TEST(ScoreUntested, DecidesNoPoints) {
    Rubric rubric;
    rubric.items = {itemWith({rule("a")})};
    SubmissionResult result;
    scoreUntested(rubric, Verdict::Human, "It cannot be read.", result);
    ASSERT_EQ(result.items.size(), 1u);
    EXPECT_TRUE(std::isnan(result.items[0].points));
    EXPECT_TRUE(std::isnan(result.total));
    EXPECT_TRUE(needsHuman(result));
}

/// Random rubrics and outcomes, fixed seed.
class RandomScoring {
public:
    double unit() { return std::uniform_real_distribution<double>(0, 1)(m_random); }

    std::size_t below(std::size_t n) { return m_random() % n; }

    RubricItem item() {
        RubricItem item;
        item.id = "item";
        item.points = static_cast<double>(1 + below(3000)) / 100;
        item.latentFraction = unit();
        const std::size_t count = 1 + below(6);
        for (std::size_t i = 0; i < count; ++i) {
            constexpr Severity severities[] = {Severity::Blemish, Severity::Latent,
                                               Severity::Visible};
            RubricCheck check = rule(std::to_string(i), severities[below(3)], 3 * unit());
            check.keeps = below(4) == 0 ? unit() : 1;
            check.tolerance = 0.001 + 0.1 * unit();
            check.gross = check.tolerance + unit();
            item.checks.push_back(check);
        }
        return item;
    }

    std::vector<CheckResult> outcomes(const RubricItem &item) {
        std::vector<CheckResult> checks;
        for (const RubricCheck &check : item.checks)
            checks.push_back(outcome(check.id, kVerdicts[below(std::size(kVerdicts))],
                                     below(5) == 0 ? kNoNumber : 1.2 * unit()));
        return checks;
    }

private:
    std::mt19937 m_random{20240604};
};

TEST(ScoringProperty, StaysWithinBoundsAndHundredthsInAnyOrder) {
    RandomScoring random;
    for (int round = 0; round < 20000; ++round) {
        const RubricItem item = random.item();
        std::vector<CheckResult> outcomes = random.outcomes(item);
        const ItemResult result = scoreItem(item, outcomes);
        ASSERT_GE(result.points, 0);
        ASSERT_LE(result.points, item.points);
        ASSERT_EQ(toPoints(toHundredths(result.points)), result.points);
        ASSERT_FALSE(result.reason.empty());
        std::reverse(outcomes.begin(), outcomes.end());
        ASSERT_EQ(scoreItem(item, outcomes).points, result.points);
    }
}

TEST(ScoringProperty, NeverGivesFewerPointsForASmallerEffectOrAPass) {
    RandomScoring random;
    for (int round = 0; round < 20000; ++round) {
        const RubricItem item = random.item();
        std::vector<CheckResult> outcomes = random.outcomes(item);
        const double before = scoreItem(item, outcomes).points;
        CheckResult &better = outcomes[random.below(outcomes.size())];
        if (better.verdict == Verdict::Fail && !std::isnan(better.effect))
            better.effect *= random.unit();
        else
            better.verdict = Verdict::Pass;
        ASSERT_GE(scoreItem(item, outcomes).points, before);
    }
}

TEST(ScoringProperty, LosesNoPointWithoutADefect) {
    RandomScoring random;
    for (int round = 0; round < 5000; ++round) {
        const RubricItem item = random.item();
        std::vector<CheckResult> outcomes = random.outcomes(item);
        for (CheckResult &check : outcomes) {
            constexpr Verdict harmless[] = {Verdict::Pass, Verdict::Inconclusive, Verdict::Infra,
                                            Verdict::Human};
            check.verdict = harmless[random.below(4)];
        }
        ASSERT_EQ(scoreItem(item, outcomes).points, item.points);
    }
}

TEST(ScoringProperty, NeverExceedsTheCap) {
    RandomScoring random;
    for (int round = 0; round < 5000; ++round) {
        Rubric rubric;
        rubric.cap = static_cast<double>(1 + random.below(10000)) / 100;
        std::vector<CheckResult> outcomes;
        for (int i = 0; i < 5; ++i) {
            rubric.items.push_back(random.item());
            rubric.items.back().extra = random.below(3) == 0;
        }
        for (const RubricItem &item : rubric.items) {
            for (const CheckResult &check : random.outcomes(item))
                outcomes.push_back(check);
        }
        SubmissionResult result;
        score(rubric, outcomes, result);
        ASSERT_GE(result.total, 0);
        ASSERT_LE(result.total, rubric.cap);
        ASSERT_EQ(result.cap, rubric.cap);
    }
}

} // namespace
} // namespace grader
