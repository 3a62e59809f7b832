// SPDX-License-Identifier: MIT
#include "page.h"

#include <battery/inputs.h>
#include <battery/nearest_mistake.h>
#include <grader/report/warp_page.h>
#include <grader/text_file.h>

#include <utility>
#include <vector>

#include <viewer/cloud.h>
#include <viewer/report_json.h>

namespace {

grader::TestedWarp shown(const viewer::Tested &test) {
    const viewer::Subject &subject = *test.subject;
    const viewer::Settings &settings = test.report.settings;
    grader::TestedWarp warp;
    warp.truth = subject.truth;
    warp.title = viewer::title(subject, test.report);
    warp.result = test.report.result;
    warp.significance = settings.significance;
    warp.maps = test.report.maps;
    warp.pointSet = viewer::kPointSetNames.at(static_cast<std::size_t>(settings.points));
    if (!test.report.result.error.empty()) {
        return warp; // it would only throw again
    }
    const double a = settings.parameter;
    warp.inputs = viewer::makeInputs(settings);
    warp.points = subject.warp(warp.inputs, a);
    const std::vector<battery::Output> independent =
        subject.warp(battery::randomInputs(viewer::kMapPoints, settings.seed), a);
    warp.moments = battery::momentRows(*subject.truth, a, independent);
    if (test.report.result.verdict == battery::Status::Fail) {
        warp.mistakes = battery::rankMistakes(*subject.truth, a, independent);
    }
    return warp;
}

} // namespace

void writePage(const CommandLine &line, const std::vector<viewer::Tested> &tests) {
    grader::WarpPage page;
    page.command = line.text;
    page.version = NORI_VERSION;
    page.json = viewer::documentJson(tests);
    for (const viewer::Tested &test : tests) {
        page.tests.push_back(shown(test));
    }
    grader::writeTextFile(line.html, grader::warpPage(page));
}
