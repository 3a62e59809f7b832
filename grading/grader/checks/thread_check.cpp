// SPDX-License-Identifier: MIT
#include "thread_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

namespace grader {

namespace {

std::size_t differences(const std::vector<float> &a, const std::vector<float> &b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        count += std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i]) ? 1 : 0;
    return count;
}

} // namespace

CheckResult compareThreads(CheckContext &context, protocol::RequestGroup group, const char *what,
                           const char *diagnosis) {
    const ProbeAnswer answer = context.ask(group);
    if (auto failure = unanswered(answer))
        return *failure;
    const std::vector<float> &once = answer.responses[0].values;
    const std::size_t other = differences(once, answer.responses[1].values);
    CheckResult result =
        makeResult(Verdict::Pass, fmt::format("On {} threads {} of {} {} are not as "
                                              "on one.",
                                              kThreads, other, once.size(), what));
    result.effect = 0;
    if (other == 0)
        return result;
    group.requests[1] = group.requests[0];
    const ProbeAnswer again = context.ask(group);
    if (auto failure = unanswered(again))
        return *failure;
    if (differences(again.responses[0].values, again.responses[1].values) > 0) {
        result.message +=
            " On one thread, too, they come out differently each time: nothing can be "
            "said of threads.";
        return result;
    }
    result.verdict = Verdict::Fail;
    result.diagnoses = {{diagnosis, 1}};
    result.effect = 1; // how many is chance; that there are any is not
    return result;
}

} // namespace grader
