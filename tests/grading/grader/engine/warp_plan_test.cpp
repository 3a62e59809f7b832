// SPDX-License-Identifier: MIT
#include <catalog/warp_catalog.h>
#include <grader/build/base.h>
#include <grader/checks/check.h>
#include <grader/engine/box_context.h>
#include <grader/engine/groups.h>
#include <grader/engine/warp_plan.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace grader {
namespace {

/// Our warp.cpp as a hand-in, with functions that throw.
class WarpPlanTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        ASSERT_GE(s_sandbox.level(), SandboxLevel::S2) << s_sandbox.findings().back();
    }

    /// \param function  `Warp::squareToTent`
    void spoil(const std::string &function) {
        const std::size_t body = m_text.find('{', m_text.find(function + "("));
        ASSERT_NE(body, std::string::npos) << function;
        m_text.insert(body + 1, " throw 1;");
    }

    Verdict verdictOf(const std::string &check, const VariantPlan &plan) {
        Submission submission;
        submission.files = {{"src/warp.cpp", "warp.cpp", FileRole::Source, "", m_text}};
        Compiler compiler(s_sandbox, s_cache);
        VariantBuilder builder(compiler, submission, 2);
        const Variant variant = builder.build(plan);
        for (const BuildFailure &failure : variant.failures)
            ADD_FAILURE() << failure.describe();
        if (!variant.executable)
            return Verdict::BuildError;
        ReferenceAnswers known;
        BoxContext context(s_sandbox, nullptr, *variant.executable, "", known, "00|" + check, "");
        return findCheck(check)->run(context).verdict;
    }

    static VariantPlan mended(const std::set<std::string> &functions) {
        return mendedWarps(studentPlan(findGroup("warp")), functions);
    }

    std::string m_text = referenceBase().units.at("warp.cpp");
    static inline const Sandbox s_sandbox{SandboxLevel::S3};
    static inline const Cache s_cache{std::filesystem::temp_directory_path() /
                                      "norigrade-test-cache"};
};

TEST_F(WarpPlanTest, FindsAWarpRightThatCallsAWrongOne) {
    spoil("Warp::squareToUniformDisk");
    const std::size_t call = m_text.find("onDisk", m_text.find("Warp::squareToCosineHemisphere("));
    m_text.replace(call, std::string("onDisk").size(), "squareToUniformDisk");
    const std::string check = "warp.cosine_hemisphere.samples";
    EXPECT_EQ(verdictOf(check, studentPlan(findGroup("warp"))), Verdict::Fail);
    EXPECT_EQ(verdictOf(check, mended({"Warp::squareToUniformSphere"})), Verdict::Fail);
    EXPECT_EQ(verdictOf(check, mended({"Warp::squareToUniformDisk"})), Verdict::Pass);
}

TEST_F(WarpPlanTest, KeepsAWrongWarpAndEveryDensityOfTheOthers) {
    spoil("Warp::squareToCosineHemisphere");
    spoil("Warp::squareToUniformSpherePdf");
    EXPECT_EQ(verdictOf("warp.cosine_hemisphere.samples", mended({"Warp::squareToUniformDisk"})),
              Verdict::Fail);
    EXPECT_EQ(verdictOf("warp.sphere.density", mended({"Warp::squareToUniformDisk"})),
              Verdict::Fail);
}

TEST_F(WarpPlanTest, KnowsEveryGradedFunctionByItsSymbol) {
    std::set<std::string> items;
    std::set<std::string> functions;
    for (const catalog::WarpEntry &warp : catalog::warpCatalog()) {
        if (warp.rubricId.empty())
            continue;
        spoil(warp.warpFunction);
        spoil(warp.densityFunction);
        functions.insert({warp.warpFunction, warp.densityFunction});
        items.insert(warp.rubricId);
    }
    for (const std::string &item : items) {
        for (const char *check : {".edges", ".density"}) {
            EXPECT_EQ(verdictOf(item + check, studentPlan(findGroup("warp"))), Verdict::Fail);
            EXPECT_EQ(verdictOf(item + check, mended(functions)), Verdict::Pass);
        }
    }
}

} // namespace
} // namespace grader
