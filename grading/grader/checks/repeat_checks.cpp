// SPDX-License-Identifier: MIT
//
// One image again with the same numbers of the sampler: bit for bit the same, on any thread.
#include <grader/checks/answer.h>
#include <grader/checks/image_scene.h>

#include <fmt/core.h>

#include <bit>
#include <cstdint>

#include "check_groups.h"
#include "radiance_check.h"
#include "thread_check.h"

namespace grader {

namespace {

/// One image twice in one process with the same numbers of the sampler, compared bit for bit.
CheckResult judgeSampler(CheckContext &context) {
    constexpr int kAgain = 16;
    const std::uint64_t seed = context.seed("image");
    const protocol::RequestGroup group = {
        imageTemplate("box").fill(context.seed("scene")),
        {imageRequest("", kAgain, seed), imageRequest("", kAgain, seed)}};
    const ProbeAnswer answer = context.ask(group);
    if (auto failure = unanswered(answer))
        return *failure;
    const std::vector<float> &first = answer.responses[0].values;
    const std::vector<float> &second = answer.responses[1].values;
    std::size_t other = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
        other += std::bit_cast<std::uint32_t>(first[i]) != std::bit_cast<std::uint32_t>(second[i])
                     ? 1
                     : 0;
    const double part = static_cast<double>(other) / static_cast<double>(first.size());
    CheckResult result = makeResult(other == 0 ? Verdict::Pass : Verdict::Fail,
                                    fmt::format("With the same numbers from the sampler {:.2g} % "
                                                "of the samples come out differently.",
                                                100 * part),
                                    {{"ems.own_random_numbers"}});
    result.effect = part;
    return result;
}

/// Each pixel has the same numbers from the sampler, whoever computes it.
CheckResult judgeThreads(CheckContext &context) {
    constexpr int kAgain = 16;
    const std::uint64_t seed = context.seed("image");
    protocol::RequestGroup group = {
        imageTemplate("box").fill(context.seed("scene")),
        {imageRequest("", kAgain, seed), imageRequest("", kAgain, seed)}};
    group.requests[1].index = kThreads - 1;
    return compareThreads(context, std::move(group), "samples of an image", "ems.shared_state");
}

} // namespace

std::vector<Check> repeatChecks() {
    constexpr double kTolerance = 0.03;
    constexpr double kGross = 0.3;
    return {
        directEmsCheck("sampler", "All random numbers come from the sampler.", judgeSampler,
                       kTolerance, kGross),
        directEmsCheck("threads", "Threads do not disturb each other.", judgeThreads, kTolerance,
                       kGross),
    };
}

} // namespace grader
