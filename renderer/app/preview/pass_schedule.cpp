// SPDX-License-Identifier: MIT
#include <algorithm>

#include <preview/pass_schedule.h>

namespace preview {

namespace {

constexpr int kFewestSamples = 4;
constexpr int kShare = 16; ///< the passes are thrown away: what they may cost

} // namespace

std::vector<int> passSchedule(int samplesPerPixel) {
    std::vector<int> passes;
    if (samplesPerPixel < kFewestSamples)
        return passes;
    int left = std::max(samplesPerPixel / kShare, 1);
    for (int samples = 1; samples <= left; samples = passes.size() < 2 ? 1 : 2 * samples) {
        passes.push_back(samples);
        left -= samples;
    }
    return passes;
}

} // namespace preview
