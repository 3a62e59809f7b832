// SPDX-License-Identifier: MIT
#include "item_times.h"

#include <grader/app/load_rubric.h>
#include <grader/engine/check_runner.h>
#include <grader/scoring/scoring.h>

#include <sys/resource.h>

#include <algorithm>
#include <map>

namespace exam {

namespace {

double cpuSeconds(int who) {
    rusage usage{};
    getrusage(who, &usage);
    const auto seconds = [](const timeval &time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Readings of all clocks, or what lies between two of them.
struct Reading {
    double wall = 0, children = 0, self = 0;

    static Reading now(const grader::CheckRunner &runner) {
        return {runner.sampleSeconds(), cpuSeconds(RUSAGE_CHILDREN), cpuSeconds(RUSAGE_SELF)};
    }

    Reading since(const Reading &start) const {
        return {wall - start.wall, children - start.children, self - start.self};
    }
};

void add(ItemTime &item, const std::string &check, const Reading &taken) {
    item.samplingWall += taken.wall;
    item.samplingCpu += taken.children;
    item.judgingCpu += taken.self;
    if (taken.children >= item.slowestCpu) {
        item.slowest = check;
        item.slowestCpu = taken.children;
    }
}

} // namespace

struct ItemClock::State {
    grader::Sandbox sandbox;
    grader::Cache cache;
    grader::Rubric rubric = grader::loadRubric({});
    std::filesystem::path referenceProbe = cache.install(NORI_REFERENCE_PROBE);
};

ItemClock::ItemClock() : m_state(std::make_unique<State>()) {}

ItemClock::~ItemClock() = default;

std::vector<ItemTime> ItemClock::measure(const std::filesystem::path &handIn,
                                         const std::string &name, const std::string &seed) const {
    const grader::Submission submission = grader::readSubmission(handIn);
    grader::Compiler compiler(m_state->sandbox, m_state->cache);
    grader::VariantBuilder builder(compiler, submission, 1);
    builder.compileAll([](double) {});
    const grader::EngineOptions options{
        .seedHex = seed, .jobs = 1, .rubric = &m_state->rubric, .asked = &m_state->rubric};
    grader::CheckRunner runner(m_state->sandbox, options, m_state->referenceProbe, builder,
                               submission.digest);
    std::map<std::string, ItemTime> times;
    std::map<std::string, bool> lost;
    for (const grader::Check &check : grader::checkTable()) {
        const auto item =
            std::find_if(m_state->rubric.items.begin(), m_state->rubric.items.end(),
                         [&](const grader::RubricItem &each) { return each.id == check.item; });
        if (item == m_state->rubric.items.end())
            continue;
        const auto rule =
            std::find_if(item->checks.begin(), item->checks.end(),
                         [&](const grader::RubricCheck &each) { return each.id == check.id; });
        if (rule == item->checks.end())
            continue;
        const Reading start = Reading::now(runner);
        const grader::CheckResult result =
            runner.runGroup(grader::findGroup(check.group), {&check}, [] {}).front();
        ItemTime &time = times[check.item];
        time.handIn = name;
        time.item = check.item;
        add(time, check.id, Reading::now(runner).since(start));
        const double score = grader::checkScore(*rule, result.verdict, result.effect, result.floor);
        lost[check.item] =
            lost[check.item] || (score < 1 && rule->severity != grader::Severity::Blemish);
        if (!time.isGross && result.verdict == grader::Verdict::Fail && score == 0 &&
            rule->severity == grader::Severity::Visible) {
            time.isGross = true;
            time.decidedWall = time.samplingWall;
            time.decidedCpu = time.samplingCpu;
        }
    }
    std::vector<ItemTime> result;
    for (const auto &[id, time] : times) {
        if (lost[id])
            result.push_back(time);
    }
    return result;
}

} // namespace exam
