// SPDX-License-Identifier: MIT
#include "prober.h"

#include <grader/error.h>
#include <grader/sandbox/descriptor.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

namespace grader {

namespace {

constexpr char kProbeInside[] = "/probe";

Descriptor makeMemory(const char *name) {
    Descriptor memory(::memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!memory)
        throw GraderError("no shared memory can be made: too many files are open");
    return memory;
}

void writeAll(int fd, const char *data, std::size_t size) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t count = ::pwrite(fd, data + done, size - done, static_cast<off_t>(done));
        if (count <= 0)
            throw GraderError("the shared memory cannot be written: is the machine out of memory?");
        done += static_cast<std::size_t>(count);
    }
}

std::string readAll(int fd, std::size_t size) {
    std::string copy(size, '\0');
    std::size_t done = 0;
    while (done < size) {
        const ssize_t count =
            ::pread(fd, copy.data() + done, size - done, static_cast<off_t>(done));
        if (count <= 0)
            throw GraderError("the shared memory cannot be read");
        done += static_cast<std::size_t>(count);
    }
    return copy;
}

void seal(int fd, int seals) {
    if (::fcntl(fd, F_ADD_SEALS, seals | F_SEAL_SEAL | F_SEAL_SHRINK | F_SEAL_GROW) != 0)
        throw GraderError("the shared memory cannot be sealed");
}

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

    const Descriptor in = makeMemory("questions");
    writeAll(in.get(), questions.data(), questions.size());
    seal(in.get(), F_SEAL_WRITE);
    const Descriptor out = makeMemory("answers");
    writeAll(out.get(), answers.data(), answers.size());
    seal(out.get(), 0);

    BoxSpec spec;
    spec.argv = {kProbeInside};
    spec.binds = {{executable, kProbeInside, false}};
    spec.limits = limits;
    spec.descriptors = {in.get(), out.get()};

    ProbeAnswer answer;
    answer.outcome = sandbox.run(spec);
    // Nothing of the box is left now, so the copy is all there will ever be.
    answers = readAll(out.get(), layout.size);
    for (std::size_t i = 0; i < group.requests.size(); ++i)
        answer.responses.push_back(protocol::readSlot(layout, group, i, answers.data()));
    return answer;
}

} // namespace grader
