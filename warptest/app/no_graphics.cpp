// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "graphics.h"

namespace {

constexpr char kReason[] =
    "this warptest was built without windows and pictures (NORI_GUI=OFF); `warptest WARP` works";

} // namespace

void showWarpWindow(const CommandLine &, const std::vector<viewer::Subject> &) {
    throw std::runtime_error(kReason);
}

std::string saveEvidence(const viewer::Subject &, const viewer::TestReport &, const std::string &) {
    throw std::runtime_error(kReason);
}
