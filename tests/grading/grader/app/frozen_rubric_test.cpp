// SPDX-License-Identifier: MIT
#include <grader/app/frozen_rubric.h>

#include <gtest/gtest.h>

#include <unistd.h>

namespace grader {

TEST(FrozenRubric, tells_whether_a_rubric_is_as_it_was_calibrated) {
    const std::filesystem::path rubric =
        std::filesystem::temp_directory_path() / ("rubric-" + std::to_string(::getpid()) + ".toml");
    Provenance provenance = {"0.1.0", "p2", "aa", "bb", "g++ 12"};
    EXPECT_EQ(describeFrozen(rubric, provenance), "");
    EXPECT_EQ(describeFrozen("", provenance), "");
    freezeRubric(rubric, provenance, 38, 3);
    EXPECT_NE(describeFrozen(rubric, provenance).find("38 hand-ins with 3 seeds"),
              std::string::npos);
    provenance.baseDigest = "cc";
    EXPECT_NE(describeFrozen(rubric, provenance).find("another norigrade or base"),
              std::string::npos);
    provenance.rubricDigest = "dd";
    EXPECT_NE(describeFrozen(rubric, provenance).find("has changed"), std::string::npos);
    std::filesystem::remove(frozenFile(rubric));
}

} // namespace grader
