// SPDX-License-Identifier: MIT
#include "prober.h"

#include <grader/sandbox/memory_file.h>

#include <fcntl.h>

#include <algorithm>

namespace grader {

namespace {

constexpr char kProbeInside[] = "/probe";

} // namespace

bool ProbeAnswer::complete() const {
    return std::all_of(responses.begin(), responses.end(), [](const protocol::Response &response) {
        return response.state == protocol::State::Done;
    });
}

ProbeAnswer askProbe(const Sandbox &sandbox, const std::filesystem::path &executable,
                     const protocol::RequestGroup &group, const BoxLimits &limits) {
    const std::string questions = protocol::encode(group);
    const protocol::SlotLayout layout = protocol::slotLayout(group);
    std::string answers(layout.size, '\0');
    protocol::clearSlots(layout, answers.data());

    const Descriptor in = makeMemoryFile("questions", questions);
    sealMemoryFile(in, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW);
    const Descriptor out = makeMemoryFile("answers", answers);
    sealMemoryFile(out, F_SEAL_SHRINK | F_SEAL_GROW);

    BoxSpec spec;
    spec.argv = {kProbeInside};
    spec.binds = {{executable, kProbeInside, false}};
    spec.limits = limits;
    spec.descriptors = {in.get(), out.get()};

    ProbeAnswer answer;
    answer.outcome = sandbox.run(spec);
    // Nothing of the box is left now, so the copy is all there will ever be.
    answers = readMemoryFile(out, layout.size);
    for (std::size_t i = 0; i < group.requests.size(); ++i)
        answer.responses.push_back(protocol::readSlot(layout, group, i, answers.data()));
    return answer;
}

} // namespace grader
