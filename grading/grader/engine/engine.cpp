// SPDX-License-Identifier: MIT
#include "engine.h"

#include <grader/engine/check_runner.h>
#include <grader/engine/groups.h>
#include <grader/error.h>
#include <grader/figures/figure_check.h>
#include <grader/scoring/scoring.h>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <set>

namespace grader {

namespace {

/// Shares of the progress: building, checks, and the rest is figures.
constexpr double kBuildShare = 0.3;
constexpr double kCheckShare = 0.6;

/// Three renders of the parts of one figure.
constexpr BoxLimits kFigureLimits = {.cpu = std::chrono::seconds(30),
                                     .wall = std::chrono::seconds(120),
                                     .memoryBytes = std::uint64_t{3} << 30,
                                     .fileBytes = std::uint64_t{64} << 20,
                                     .logBytes = std::uint64_t{1} << 20,
                                     .processes = 32};

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The checks that the rubric asks for, of one group, in the table's order.
std::vector<const Check *> checksOf(const Rubric &rubric, const std::string &group) {
    std::vector<const Check *> checks;
    for (const Check &check : checkTable()) {
        const bool wanted =
            check.group == group &&
            std::any_of(rubric.items.begin(), rubric.items.end(), [&](const RubricItem &item) {
                return std::any_of(item.checks.begin(), item.checks.end(),
                                   [&](const RubricCheck &row) { return row.id == check.id; });
            });
        if (wanted)
            checks.push_back(&check);
    }
    return checks;
}

} // namespace

Engine::Engine(const Sandbox &sandbox, const EngineOptions &options)
    : m_sandbox(sandbox), m_options(options) {
    const SandboxLevel needed = options.rubric->minSandbox;
    if (sandbox.level() < std::max(needed, SandboxLevel::S2)) {
        std::string findings;
        for (const std::string &line : sandbox.findings())
            findings += "\n  " + line;
        throw SandboxTooWeak(
            fmt::format("this machine gives sandbox level {}, the rubric asks for {}:{}",
                        sandboxLevelName(sandbox.level()), sandboxLevelName(needed), findings));
    }
    m_referenceProbe = m_cache.install(NORI_REFERENCE_PROBE);
}

std::vector<CheckResult> Engine::runChecks(VariantBuilder &builder, const Submission &submission,
                                           const ProgressCallback &progress,
                                           double &sampleSeconds) {
    const Rubric &asked = *m_options.asked;
    const Rubric &all = *m_options.rubric;
    std::set<std::string> groups;
    std::set<std::string> upstream;
    for (const Group &group : groupTable()) {
        if (checksOf(asked, group.id).empty())
            continue;
        groups.insert(group.id);
        upstream.insert(group.upstream.begin(), group.upstream.end());
        if (checksOf(asked, group.id).size() < checksOf(all, group.id).size())
            upstream.insert(group.id); // its code may call that of the group's other items
        if (std::count(group.own.begin(), group.own.end(), "direct_ems.cpp") != 0)
            upstream.insert(kChoiceGroups.begin(), kChoiceGroups.end()); // see settle()
    }
    CheckRunner runner(m_sandbox, m_options, m_referenceProbe, builder, submission.digest);
    const auto run = [&](const std::set<std::string> &wanted, const Rubric &rubric) {
        std::size_t count = 0;
        for (const std::string &id : wanted)
            count += checksOf(rubric, id).size();
        std::atomic<std::size_t> done{0};
        std::vector<CheckResult> outcomes;
        for (const Group &group : groupTable()) {
            if (wanted.count(group.id) == 0)
                continue;
            const std::vector<CheckResult> results =
                runner.runGroup(group, checksOf(rubric, group.id), [&] {
                    progress("checking " + group.id, kBuildShare + kCheckShare *
                                                                       static_cast<double>(++done) /
                                                                       static_cast<double>(count));
                });
            outcomes.insert(outcomes.end(), results.begin(), results.end());
        }
        runner.settle(outcomes);
        return outcomes;
    };
    std::vector<CheckResult> outcomes = run(groups, asked);
    // With everything asked for, what a group stands on was run before it.
    const bool isPart = asked.items.size() < all.items.size();
    if (runner.foundFault() && isPart && !upstream.empty()) {
        groups.merge(upstream);
        runner.startAnew();
        outcomes = run(groups, all);
    }
    sampleSeconds = runner.sampleSeconds();
    return outcomes;
}

SubmissionResult Engine::grade(const Submission &submission, const ProgressCallback &progress) {
    const auto start = std::chrono::steady_clock::now();
    SubmissionResult result;
    result.name = submission.name;
    result.members = submission.members;
    result.sandbox = sandboxLevelName(m_sandbox.level());
    result.seed = m_options.seedHex;
    result.notes = submission.notes;

    Compiler compiler(m_sandbox, m_cache);
    VariantBuilder builder(compiler, submission, m_options.jobs);
    builder.compileAll([&](double fraction) {
        if (m_options.interrupted != nullptr && *m_options.interrupted)
            throw Interrupted();
        progress("compiling", kBuildShare * fraction);
    });

    const double beforeChecks = secondsSince(start);
    double sampleSeconds = 0;
    const std::vector<CheckResult> outcomes =
        runChecks(builder, submission, progress, sampleSeconds);
    score(*m_options.asked, outcomes, result);
    for (const Note &note : builder.notes())
        result.notes.push_back(note);

    const double beforeFigures = secondsSince(start);
    if (m_options.scenes != nullptr)
        compareFigures(submission, builder, progress, result);
    result.timing.figures = secondsSince(start) - beforeFigures;

    result.timing.compile = compiler.compileSeconds();
    result.timing.link = compiler.linkSeconds();
    result.timing.sample = sampleSeconds;
    result.timing.total = secondsSince(start);
    // Boxes run side by side, so their sum may be longer than the clock's time.
    result.timing.judge =
        std::max(0.0, beforeFigures - beforeChecks - sampleSeconds / m_options.jobs);
    return result;
}

void Engine::compareFigures(const Submission &submission, VariantBuilder &builder,
                            const ProgressCallback &progress, SubmissionResult &result) const {
    const Variant own = builder.build(studentPlan(findGroup("direct_ems")));
    const auto stopIfInterrupted = [this] {
        if (m_options.interrupted != nullptr && *m_options.interrupted)
            throw Interrupted();
    };
    FigureCheck check{
        *m_options.scenes, m_options.seedHex + "|figures", {}, {}, m_options.jobs, {}};
    check.decode = [this](std::string_view bytes) {
        return decodeImage(m_sandbox, bytes);
    };
    check.ask = [&](const protocol::RequestGroup &group) {
        stopIfInterrupted();
        if (own.executable)
            return askProbe(m_sandbox, *own.executable, group, kFigureLimits);
        ProbeAnswer none; // says the same as a program that does not know the scene's parts
        protocol::Response response;
        response.state = protocol::State::Threw;
        response.message =
            own.failures.empty() ? "it was not built" : own.failures.back().describe();
        none.responses.assign(group.requests.size(), response);
        return none;
    };
    check.progress = [&](double fraction) {
        stopIfInterrupted();
        progress("comparing figures",
                 kBuildShare + kCheckShare + (1 - kBuildShare - kCheckShare) * fraction);
    };
    try {
        result.figures = checkFigures(submission, check);
    } catch (const GraderError &error) { // the marks do not depend on them
        result.notes.push_back(
            {Note::Level::Odd, "",
             fmt::format("The figures could not be compared: {}", error.what())});
    }
}

} // namespace grader
