// SPDX-License-Identifier: MIT
#include "interrupt.h"

#include <unistd.h>

#include <csignal>

namespace grader {

namespace {

std::atomic<bool> interrupted{false}; // a signal handler can reach nothing but a global
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

constexpr char kNotice[] = "\nnorigrade: stopping; once more stops at once\n";

extern "C" void onInterrupt(int /*signal*/) {
    interrupted = true;
    // The only kind of output that is allowed in a handler; nothing can be done if it fails.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kNotice, sizeof(kNotice) - 1);
}

} // namespace

const std::atomic<bool> &catchInterrupts() {
    struct sigaction action {};

    action.sa_handler = onInterrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    return interrupted;
}

} // namespace grader
