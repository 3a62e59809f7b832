// SPDX-License-Identifier: MIT
#include <grader/rubric/nearest_name.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

const std::vector<std::string> kVerbs = {"grade", "check", "doctor"};

TEST(NearestName, FindsAMistypedName) {
    EXPECT_EQ(nearestName("gread", kVerbs), "grade");
    EXPECT_EQ(nearestName("docter", kVerbs), "doctor");
    EXPECT_EQ(nearestName("check", kVerbs), "check");
}

TEST(NearestName, DoesNotGuessWhenNothingIsNear) {
    EXPECT_EQ(nearestName("export", kVerbs), "");
    EXPECT_EQ(nearestName("", kVerbs), "");
    EXPECT_EQ(nearestName("grade", {}), "");
}

TEST(NearestName, SuggestsOrListsWhatIsKnown) {
    EXPECT_EQ(suggestion("grad", kVerbs), " (did you mean \"grade\"?)");
    EXPECT_EQ(suggestion("export", kVerbs), " (known: grade, check, doctor)");
}

} // namespace
} // namespace grader
