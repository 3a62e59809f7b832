// SPDX-License-Identifier: MIT
#include <battery/inputs.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <stdexcept>

#include <viewer/cloud.h>

namespace viewer {

namespace {

constexpr int kBoundaryPoints = 256;

int sideOf(std::size_t count) {
    return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count))));
}

/// Radical inverse of `index` in `base`, in [0, 1).
double radicalInverse(std::size_t index, std::size_t base) {
    double value = 0.0;
    double digit = 1.0 / static_cast<double>(base);
    for (; index > 0; index /= base) {
        value += static_cast<double>(index % base) * digit;
        digit /= static_cast<double>(base);
    }
    return value;
}

/// Halton's points in bases 2 and 3, moved by a random vector modulo 1 (Cranley and Patterson).
std::vector<battery::Input> haltonInputs(std::size_t count, std::uint64_t seed) {
    const battery::Input shift = battery::randomInputs(1, seed).front();
    const auto wrap = [](double x, float by) {
        const double moved = x + static_cast<double>(by);
        return std::min(static_cast<float>(moved - std::floor(moved)), 0x1.fffffep-1F);
    };
    std::vector<battery::Input> inputs(count);
    for (std::size_t i = 0; i < count; ++i) {
        inputs[i] = {wrap(radicalInverse(i, 2), shift.u), wrap(radicalInverse(i, 3), shift.v)};
    }
    return inputs;
}

/// Calls a subject's function. \return  what it threw, or nothing
template <typename Function>
std::string messageOf(const Function &function) {
    try {
        function();
    } catch (const std::exception &error) {
        return error.what();
    } catch (...) {
        return "an exception that is no std::exception";
    }
    return {};
}

std::vector<battery::Output> callWarp(const Subject &subject,
                                      std::span<const battery::Input> inputs, double a) {
    std::vector<battery::Output> outputs = subject.warp(inputs, a);
    if (outputs.size() != inputs.size()) {
        throw std::length_error("the warp returned another number of points");
    }
    return outputs;
}

std::vector<battery::Input> gridInputs() {
    const auto place = [](int i, int n) {
        return std::min(static_cast<float>(i) / static_cast<float>(n), 0x1.fffffep-1F);
    };
    std::vector<battery::Input> inputs;
    for (const bool alongU : {true, false}) {
        for (int line = 0; line <= kGridLines; ++line) {
            for (int step = 0; step <= kGridSteps; ++step) {
                const float fixed = place(line, kGridLines);
                const float moving = place(step, kGridSteps);
                inputs.push_back(alongU ? battery::Input{moving, fixed}
                                        : battery::Input{fixed, moving});
            }
        }
    }
    return inputs;
}

} // namespace

std::vector<battery::Input> makeInputs(const Settings &settings) {
    switch (settings.points) {
    case PointSet::Grid:
        return battery::gridInputs(sideOf(settings.count));
    case PointSet::Stratified:
        return battery::stratifiedInputs(sideOf(settings.count), settings.seed);
    case PointSet::Halton:
        return haltonInputs(settings.count, settings.seed);
    case PointSet::Independent:
        break;
    }
    return battery::randomInputs(settings.count, settings.seed);
}

double densityError(double returned, double exact) {
    if (exact <= 0.0) {
        return returned == 0.0 ? 0.0 : 1.0;
    }
    const double error = std::abs(returned - exact) / exact;
    return std::isfinite(error) ? error : 1.0;
}

Cloud makeCloud(const Subject &subject, const Settings &settings) {
    const catalog::WarpEntry &truth = *subject.truth;
    const double a = settings.parameter;
    Cloud cloud;
    cloud.inputs = makeInputs(settings);
    const auto start = std::chrono::steady_clock::now();
    cloud.warpError = messageOf([&] { cloud.outputs = callWarp(subject, cloud.inputs, a); });
    cloud.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (truth.boundary != nullptr) {
        for (int i = 0; i <= kBoundaryPoints; ++i) {
            const double t = static_cast<double>(i % kBoundaryPoints) / kBoundaryPoints;
            cloud.boundary.push_back(battery::toOutput(truth.boundary(t)));
        }
    }
    if (!cloud.warpError.empty()) {
        return cloud;
    }
    if (settings.grid) {
        const std::string ignored =
            messageOf([&] { cloud.gridLines = callWarp(subject, gridInputs(), a); });
    }
    cloud.densityError = messageOf([&] {
        cloud.densities = subject.density(cloud.outputs, a);
        if (cloud.densities.size() != cloud.outputs.size()) {
            cloud.densities.clear();
            throw std::length_error("the density returned another number of values");
        }
    });
    for (const battery::Output &output : cloud.outputs) {
        const catalog::Point point = battery::toPoint(output);
        const bool inside = catalog::placement(truth, point) == catalog::Placement::Inside;
        cloud.outside += inside ? 0 : 1;
        cloud.exact.push_back(inside ? truth.density(point, a) : 0.0);
    }
    return cloud;
}

} // namespace viewer
