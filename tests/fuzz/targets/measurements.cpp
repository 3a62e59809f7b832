// SPDX-License-Identifier: MIT
//
// The store of `norigrade calibrate`, which lies in the cache from one call to the next.
#include <grader/calibration/measurements.h>

#include <filesystem>

#include "../target.h"

namespace {

/// Where what was read is written again: a folder in memory.
std::filesystem::path otherFile() {
    static const fuzz::ScratchFolder folder;
    return folder.path() / "again.json";
}

bool isSame(double a, double b) {
    return a == b || (a != a && b != b);
}

} // namespace

void fuzz::run(std::string_view bytes) {
    using namespace grader;
    static const ScratchFile file;
    const auto checks = readMeasurements(file.write(bytes));
    if (!checks)
        return;
    writeMeasurements(otherFile(), *checks);
    const auto again = readMeasurements(otherFile());
    require(again && again->size() == checks->size(), "what was read can be kept");
    for (std::size_t i = 0; i < checks->size(); ++i) {
        const CheckResult &a = (*checks)[i];
        const CheckResult &b = (*again)[i];
        require(a.verdict == b.verdict && isSame(a.effect, b.effect) &&
                    a.diagnoses.size() == b.diagnoses.size(),
                "a kept check is the same");
    }
}
