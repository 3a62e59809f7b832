// SPDX-License-Identifier: MIT
#include "engine.h"

#include <grader/digest.h>
#include <grader/engine/check_runner.h>
#include <grader/error.h>
#include <grader/scoring/scoring.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <set>

namespace grader {

namespace {

/// Share of the progress that building takes; the rest is checks.
constexpr double kBuildShare = 0.3;

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A copy in the cache, where boxes can reach it.
std::filesystem::path installReferenceProbe(const Cache &cache) {
    const std::string bytes = readTextFile(NORI_REFERENCE_PROBE);
    const std::filesystem::path file = cache.entry("executables", sha256Hex(bytes));
    if (!std::filesystem::exists(file)) {
        writeTextFile(file, bytes);
        using std::filesystem::perms;
        std::filesystem::permissions(file,
                                     perms::owner_exec | perms::group_exec | perms::others_exec,
                                     std::filesystem::perm_options::add);
    }
    return file;
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
    m_referenceProbe = installReferenceProbe(m_cache);
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
    }
    bool atFault = false;
    const auto run = [&](const std::set<std::string> &wanted, const Rubric &rubric) {
        std::size_t count = 0;
        for (const std::string &id : wanted)
            count += checksOf(rubric, id).size();
        CheckRunner runner(m_sandbox, m_options, m_referenceProbe, builder, submission.digest);
        std::atomic<std::size_t> done{0};
        std::vector<CheckResult> outcomes;
        for (const Group &group : groupTable()) {
            if (wanted.count(group.id) == 0)
                continue;
            const std::vector<CheckResult> results =
                runner.runGroup(group, checksOf(rubric, group.id), [&] {
                    progress("checking " + group.id, kBuildShare + (1 - kBuildShare) *
                                                                       static_cast<double>(++done) /
                                                                       static_cast<double>(count));
                });
            outcomes.insert(outcomes.end(), results.begin(), results.end());
        }
        sampleSeconds += runner.sampleSeconds();
        atFault = runner.foundFault();
        return outcomes;
    };
    std::vector<CheckResult> outcomes = run(groups, asked);
    // With everything asked for, what a group stands on was run before it.
    const bool isPart = asked.items.size() < all.items.size();
    if (atFault && isPart && !upstream.empty()) {
        groups.merge(upstream);
        outcomes = run(groups, all);
    }
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

    result.timing.compile = compiler.compileSeconds();
    result.timing.link = compiler.linkSeconds();
    result.timing.sample = sampleSeconds;
    result.timing.total = secondsSince(start);
    // Boxes run side by side, so their sum may be longer than the clock's time.
    result.timing.judge =
        std::max(0.0, result.timing.total - beforeChecks - sampleSeconds / m_options.jobs);
    return result;
}

} // namespace grader
