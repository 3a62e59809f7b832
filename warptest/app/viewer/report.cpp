// SPDX-License-Identifier: MIT
#include <battery/inputs.h>

#include <fmt/core.h>

#include <viewer/report.h>

namespace viewer {

double defaultParameter(const catalog::WarpEntry &truth) {
    constexpr double kStock = 0.1;
    return truth.hasParameter ? kStock : truth.parameters.front();
}

bool isNamed(const Subject &subject, const std::string &name) {
    return subject.name == name || (!subject.isMistake && subject.truth->id == name);
}

std::string title(const Subject &subject, const TestReport &report) {
    return subject.truth->hasParameter
               ? fmt::format("{} α = {:.6g}", subject.name, report.settings.parameter)
               : subject.name;
}

battery::Maps drawMaps(const Subject &subject, const Settings &settings) {
    const std::vector<battery::Input> inputs = battery::randomInputs(kMapPoints, settings.seed);
    return battery::makeMaps(*subject.truth, settings.parameter,
                             subject.warp(inputs, settings.parameter), settings.rows);
}

} // namespace viewer
