// SPDX-License-Identifier: MIT
#include <battery/inputs.h>

#include <viewer/report.h>

namespace viewer {

double defaultParameter(const catalog::WarpEntry &truth) {
    constexpr double kStock = 0.1;
    return truth.hasParameter ? kStock : truth.parameters.front();
}

Maps drawMaps(const Subject &subject, const Settings &settings) {
    const std::vector<battery::Input> inputs = battery::randomInputs(kMapPoints, settings.seed);
    return makeMaps(*subject.truth, settings.parameter, subject.warp(inputs, settings.parameter));
}

} // namespace viewer
