// SPDX-License-Identifier: MIT
#include "warp_list.h"

#include <battery/records.h>
#include <catalog/density_mistakes.h>
#include <catalog/warp_catalog.h>
#include <catalog/warp_mistakes.h>
#include <grader/app/terminal.h>
#include <grader/warps/submitted_warps.h>

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <thread>
#include <utility>

#include <bindings/warp_bindings.h>

namespace {

viewer::Subject rendererWarp(const catalog::WarpEntry &truth) {
    viewer::Subject subject;
    subject.truth = &truth;
    subject.name = truth.id;
    subject.warp = [id = truth.id](std::span<const battery::Input> inputs, double a) {
        return bindings::callWarp(id, inputs, a);
    };
    subject.density = [id = truth.id](std::span<const battery::Output> points, double a) {
        return bindings::callDensity(id, points, a);
    };
    return subject;
}

} // namespace

std::vector<viewer::Subject> rendererWarps() {
    std::vector<viewer::Subject> subjects;
    for (const catalog::WarpEntry &truth : catalog::warpCatalog()) {
        subjects.push_back(rendererWarp(truth));
    }
    return subjects;
}

std::vector<viewer::Subject> submittedWarps(const std::string &path) {
    grader::ProgressLine progress(true);
    const auto jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const auto submitted = std::make_shared<const grader::SubmittedWarps>(
        path, jobs, [&](double fraction) { progress.update(path, "compiling", fraction); });
    progress.clear();
    for (const std::string &note : submitted->notes()) {
        fmt::print(stderr, "warptest: {}\n", note);
    }
    std::vector<viewer::Subject> subjects;
    for (const catalog::WarpEntry &truth : catalog::warpCatalog()) {
        viewer::Subject subject;
        subject.truth = &truth;
        subject.from = submitted->name();
        subject.name = fmt::format("{} of {}", truth.id, subject.from);
        subject.warp = [submitted, &truth](std::span<const battery::Input> inputs, double a) {
            return submitted->warp(truth, inputs, a);
        };
        subject.density = [submitted, &truth](std::span<const battery::Output> points, double a) {
            return submitted->density(truth, points, a);
        };
        subjects.push_back(std::move(subject));
    }
    return subjects;
}

std::vector<viewer::Subject> mistakenWarps() {
    std::vector<viewer::Subject> subjects;
    for (const catalog::WarpMistake &mistake : catalog::warpMistakes()) {
        viewer::Subject subject = rendererWarp(catalog::requireWarp(mistake.warpId));
        subject.name = fmt::format("{}, wrong: {}", mistake.warpId, mistake.id);
        subject.warp = [warp = mistake.warp](std::span<const battery::Input> inputs, double a) {
            std::vector<battery::Output> outputs;
            outputs.reserve(inputs.size());
            for (const battery::Input &input : inputs) {
                outputs.push_back(battery::toOutput(
                    warp({static_cast<double>(input.u), static_cast<double>(input.v)}, a)));
            }
            return outputs;
        };
        subject.isMistake = true;
        subjects.push_back(std::move(subject));
    }
    for (const catalog::DensityMistake &mistake : catalog::densityMistakes()) {
        viewer::Subject subject = rendererWarp(catalog::requireWarp(mistake.warpId));
        subject.name = fmt::format("{}, wrong pdf: {}", mistake.warpId, mistake.id);
        subject.density = [density = mistake.density](std::span<const battery::Output> points,
                                                      double a) {
            std::vector<float> densities;
            densities.reserve(points.size());
            for (const battery::Output &point : points) {
                densities.push_back(static_cast<float>(density(battery::toPoint(point), a)));
            }
            return densities;
        };
        subject.isMistake = true;
        subjects.push_back(std::move(subject));
    }
    viewer::Subject empty = rendererWarp(catalog::requireWarp("triangle"));
    empty.isMistake = true;
    empty.name = "triangle, not implemented";
    empty.warp = [](std::span<const battery::Input>, double) -> std::vector<battery::Output> {
        throw battery::NotImplemented("Warp::squareToUniformTriangle() is not implemented yet");
    };
    subjects.push_back(std::move(empty));
    return subjects;
}
