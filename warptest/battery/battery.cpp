// SPDX-License-Identifier: MIT
#include "battery.h"

#include <battery/battery_run.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <stdexcept>
#include <utility>

namespace battery {

namespace {

/// Fail is worse than Inconclusive, which is worse than Pass.
int badness(Status status) {
    return status == Status::Fail ? 2 : status == Status::Pass ? 0 : 1;
}

void require(const TestOptions &options) {
    if (options.samples == 0 || options.repeats < 1 ||
        !(options.significance > 0.0 && options.significance <= 0.1)) {
        throw std::invalid_argument("testWarp: needs samples, at least one repeat, and a "
                                    "significance in (0, 0.1]");
    }
}

void addRepeatsRow(TestResult &result) {
    const auto passed = std::count(result.repeats.begin(), result.repeats.end(), Status::Pass);
    result.rows.push_back({"repeats", "repeats that pass", std::to_string(passed),
                           std::to_string(result.repeats.size()), result.verdict});
}

/// All repeats, and the first with the worst verdict.
TestResult repeat(const TestOptions &options, const std::function<TestResult(int)> &once) {
    require(options);
    TestResult worst;
    std::vector<Status> verdicts;
    std::vector<double> pValues;
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        TestResult result = once(repeat);
        if (result.verdict == Status::NotRun) {
            return result;
        }
        verdicts.push_back(result.verdict);
        pValues.insert(pValues.end(), result.seedPValues.begin(), result.seedPValues.end());
        if (repeat == 0 || badness(result.verdict) > badness(worst.verdict)) {
            worst = std::move(result);
        }
    }
    worst.repeats = std::move(verdicts);
    worst.seedPValues = std::move(pValues);
    if (options.repeats > 1) {
        addRepeatsRow(worst);
    }
    return worst;
}

} // namespace

TestResult testWarp(const Warp &warp, const Density &density, const catalog::WarpEntry &target,
                    const TestOptions &options) {
    return repeat(options, [&](int index) {
        return BatteryRun(warp, density, target, options, index).run();
    });
}

TestResult testOwnDensity(const Warp &warp, const Density &density, const catalog::Chart &chart,
                          const TestOptions &options) {
    require(options);
    TabulatedTarget own;
    try {
        own = tabulateTarget("own density", chart, density);
    } catch (const std::exception &error) {
        TestResult failed;
        failed.verdict = Status::Fail;
        failed.headline = "the density cannot be used";
        failed.error = error.what();
        failed.repeats = {Status::Fail};
        return failed;
    }
    return repeat(options, [&](int index) { return BatteryRun(warp, own, options, index).run(); });
}

std::vector<TestResult> testEveryParameter(const WarpFamily &family,
                                           const catalog::WarpEntry &target,
                                           const TestOptions &options) {
    std::vector<TestResult> results;
    const auto count = static_cast<double>(target.parameters.size());
    for (const double a : target.parameters) {
        TestOptions here = options;
        here.parameter = a;
        const auto before = static_cast<double>(results.size());
        here.progress = [&](double fraction) {
            if (options.progress) {
                options.progress((before + fraction) / count);
            }
        };
        TestResult result =
            testWarp([&](std::span<const Input> inputs) { return family.warp(inputs, a); },
                     [&](std::span<const Output> points) { return family.density(points, a); },
                     target, here);
        if (result.verdict == Status::NotRun) {
            break;
        }
        results.push_back(std::move(result));
    }
    return results;
}

} // namespace battery
