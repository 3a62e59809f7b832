// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <signal.h>
#include <unistd.h>

#include "command_line.h"
#include "render_command.h"
#include "view_command.h"

namespace {

constexpr int kError = 1;
constexpr int kNoWindow = 2;

std::atomic<bool> cancelled{false}; // NOLINT: a signal handler can reach nothing else

extern "C" void onInterrupt(int) {
    if (cancelled.exchange(true))
        _exit(kInterrupted);
}

} // namespace

int main(int argc, char **argv) {
    int exitCode = 0;
    const std::optional<CommandLine> line = parseCommandLine(argc, argv, exitCode);
    if (!line)
        return exitCode;

    if (!namesImage(line->file)) { // nothing is to be saved of an image that is looked at

        struct sigaction action {};

        action.sa_handler = onInterrupt;
        sigaction(SIGINT, &action, nullptr);
        sigaction(SIGTERM, &action, nullptr);
    }
    signal(SIGXFSZ, SIG_IGN); // a file beyond the user's limit is an error of its writer
    try {
        return namesImage(line->file) ? viewImage(*line) : renderScene(*line, cancelled);
    } catch (const preview::CannotShow &error) {
        fmt::print(stderr, "nori: {}.\n", error.what());
        return kNoWindow;
    } catch (const std::exception &error) {
        fmt::print(stderr, "Error: {}\n", error.what());
        return kError;
    }
}
