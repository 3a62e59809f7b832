// SPDX-License-Identifier: MIT
#include <grader/diagnosis/guess.h>

#include <gtest/gtest.h>

namespace grader {

namespace {

std::vector<std::string> idsOf(const std::vector<Guess> &guesses) {
    std::vector<std::string> ids;
    for (const Guess &guess : guesses)
        ids.push_back(guess.id);
    return ids;
}

} // namespace

TEST(BestGuesses, puts_the_best_first_and_keeps_three) {
    const std::vector<Guess> all = {{"a", 0.3}, {"b", 0.9}, {"c", 0.5}, {"d", 0.7}};
    EXPECT_EQ(idsOf(bestGuesses(all)), (std::vector<std::string>{"b", "d", "c"}));
}

TEST(BestGuesses, takes_each_once_with_its_best_fit) {
    const std::vector<Guess> best = bestGuesses({{"a", 0.3}, {"b", 0.5}, {"a", 1}});
    EXPECT_EQ(idsOf(best), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(best[0].fit, 1);
}

TEST(BestGuesses, lets_the_earlier_of_equal_ones_stand_first) {
    EXPECT_EQ(idsOf(bestGuesses({{"samples", 0.97}, {"density", 1}})),
              (std::vector<std::string>{"samples", "density"}));
    EXPECT_TRUE(bestGuesses({}).empty());
}

} // namespace grader
