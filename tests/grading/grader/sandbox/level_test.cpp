// SPDX-License-Identifier: MIT
#include <grader/error.h>

#include <fmt/core.h>

#include "hostile_box.h"

namespace grader {

namespace {

std::string joined(const Sandbox &sandbox) {
    std::string text;
    for (const std::string &line : sandbox.findings())
        text += line + "\n";
    return text;
}

TEST(Level, IsTheMachinesAndSaysWhy) {
    const Sandbox sandbox;
    // Not skipped where it is weaker: a machine that grades has to give this.
    ASSERT_GE(sandbox.level(), SandboxLevel::S2) << joined(sandbox);
    EXPECT_EQ(sandbox.findings().back(),
              fmt::format("level: {}", sandboxLevelName(sandbox.level())));
    EXPECT_NE(joined(sandbox).find("bubblewrap"), std::string::npos);
    EXPECT_NE(joined(sandbox).find("control groups"), std::string::npos);
}

TEST(Level, IsNeverMoreThanWanted) {
    for (const SandboxLevel wanted :
         {SandboxLevel::S0, SandboxLevel::S1, SandboxLevel::S2, SandboxLevel::S3})
        EXPECT_LE(Sandbox(wanted).level(), wanted);
    EXPECT_EQ(Sandbox(SandboxLevel::S2).level(), SandboxLevel::S2);
}

TEST(Level, BelowS2RunsNothingAndSaysWhatToDo) {
    for (const SandboxLevel wanted : {SandboxLevel::S0, SandboxLevel::S1}) {
        const Sandbox sandbox(wanted);
        BoxSpec spec;
        spec.argv = {"/usr/bin/true"};
        try {
            sandbox.run(spec);
            FAIL() << "it ran";
        } catch (const GraderError &error) {
            EXPECT_NE(std::string(error.what()).find("norigrade doctor"), std::string::npos);
        }
        EXPECT_NE(sandbox.findings().back().find("not run"), std::string::npos);
    }
}

} // namespace

} // namespace grader
