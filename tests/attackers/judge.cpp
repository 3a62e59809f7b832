// SPDX-License-Identifier: MIT
#include "judge.h"

#include <grader/build/base.h>
#include <grader/build/variant_builder.h>
#include <grader/engine/groups.h>
#include <grader/results/safe_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "../grading/grader/sandbox/hostile_box.h"

namespace attack {

using namespace grader;

namespace fs = std::filesystem;

namespace {

/// Puts a name before everything that is asked of a program, and asks it in the box.
class NamedContext : public CheckContext {
public:
    NamedContext(const Sandbox &sandbox, fs::path program, std::string name, BoxLimits limits)
        : m_sandbox(sandbox),
          m_program(std::move(program)),
          m_name(std::move(name)),
          m_limits(limits) {}

    ProbeAnswer ask(const protocol::RequestGroup &group) override {
        protocol::RequestGroup named = group;
        named.files.insert(named.files.begin(), {m_name, ""});
        return askProbe(m_sandbox, m_program, named, m_limits);
    }

    ProbeAnswer askReference(const protocol::RequestGroup &group) override { return ask(group); }

    std::uint64_t seed(std::string_view purpose, int stage, int replicate) const override {
        return std::hash<std::string_view>()(purpose) + 1000003U * static_cast<unsigned>(stage) +
               static_cast<unsigned>(replicate);
    }

private:
    const Sandbox &m_sandbox;
    fs::path m_program;
    std::string m_name;
    BoxLimits m_limits;
};

bool isNamed(const Attack &attack, const char *name) {
    return std::strcmp(attack.name, name) == 0;
}

} // namespace

Judge::Judge(SandboxLevel level, bool quick)
    : m_sandbox(level),
      m_host({HOSTILE, ESCAPES, HOSTILE_PROBE, CHEATS}),
      m_marks(m_sandbox),
      m_quick(quick),
      m_run(fmt::format("{:x}", std::random_device()())) {}

template <typename Act>
Seen Judge::watched(const Act &act) const {
    const Host::State before = m_host.state();
    Seen seen = act();
    seen.traces = m_host.tracesSince(before);
    if (seen.traces.all() > 0)
        seen.what = fmt::format("LEFT TRACES: {}; {}", seen.traces.describe(), seen.what);
    if (seen.gained > 0)
        seen.what = fmt::format("GAINED {:g} POINTS; {}", seen.gained, seen.what);
    seen.contained = seen.contained && seen.traces.all() == 0 && seen.gained <= 0;
    return seen;
}

Seen Judge::run(const Attack &attack) {
    return watched([&] { return judge(attack); });
}

Seen Judge::judge(const Attack &attack) const {
    switch (attack.kind) {
    case Kind::Hostile:
    case Kind::Escape:
    case Kind::Compiler:
        return judgeProcess(attack);
    case Kind::Probe:
        return judgeProbe(attack);
    case Kind::Cheat:
        return judgeCheat(attack);
    case Kind::Source:
    case Kind::HandIn:
        return judgeSource(attack);
    }
    return {};
}

fs::path Judge::programOf(const Attack &attack) const {
    switch (attack.kind) {
    case Kind::Probe:
        return m_host.place(HOSTILE_PROBE);
    case Kind::Cheat:
        return m_host.place(CHEATS);
    case Kind::Escape:
        return m_host.place(ESCAPES);
    default:
        return m_host.place(isNamed(attack, "tries_rare_calls") ? ESCAPES : HOSTILE);
    }
}

std::vector<CheckResult> Judge::ask(const Attack &attack) const {
    BoxLimits limits;
    const bool computes = attack.kind == Kind::Cheat; // others answer at once or never
    limits.cpu = std::chrono::seconds(computes ? 3 : 1);
    limits.wall = std::chrono::milliseconds(computes ? 30'000 : 1500);
    limits.memoryBytes = std::uint64_t{512} << 20U;
    NamedContext context(m_sandbox, programOf(attack), attack.name, limits);
    return m_marks.check(context);
}

bool Judge::honestPasses() const {
    const std::vector<CheckResult> checks = ask({'E', Kind::Cheat, "honest", "", End::Any});
    return std::all_of(checks.begin(), checks.end(),
                       [](const CheckResult &check) { return check.verdict == Verdict::Pass; }) &&
           m_marks.pointsFor(checks) > 0;
}

Seen Judge::judgeProcess(const Attack &attack) const {
    BoxSpec spec = hostileSpec(programOf(attack), attack.name, m_host.marker());
    spec.mayFork = attack.kind == Kind::Compiler;
    spec.limits.wall = attack.end == End::Wall ? std::chrono::milliseconds(1500)
                                               : std::chrono::milliseconds(60'000);
    const BoxOutcome outcome = m_sandbox.run(spec);
    const std::size_t got = outcome.log.find("GOT");
    if (got != std::string::npos)
        return {false, safeLine(outcome.log.substr(got, 60))};
    if (outcome.log.find(kSecret) != std::string::npos)
        return {false, "READ THE SECRET"};
    const auto *exited = std::get_if<BoxExited>(&outcome.end);
    if (exited != nullptr && (exited->code == 98 || exited->code == 99))
        return {false, "is no program of that name"};
    Seen seen{endsAs(attack.end, outcome), describe(outcome.end)};
    if (!seen.contained)
        seen.what +=
            ", which is not how it must end; it said: " + safeLine(outcome.log.substr(0, 60));
    if (!m_quick)
        seen.gained = m_marks.pointsFor(ask(attack));
    return seen;
}

bool Judge::endsAs(End wanted, const BoxOutcome &outcome) const {
    const BoxEnd &end = outcome.end;
    const auto *timedOut = std::get_if<BoxTimedOut>(&end);
    const auto *exited = std::get_if<BoxExited>(&end);
    const bool tried = exited != nullptr && exited->code == 0 && outcome.log.ends_with("tried\n");
    switch (wanted) {
    case End::Exit:
        return tried;
    case End::Leave:
        return exited != nullptr && exited->code != 0;
    case End::Signal:
        return std::holds_alternative<BoxSignalled>(end);
    case End::Cpu:
        return timedOut != nullptr && timedOut->cpu;
    case End::Wall:
        return (timedOut != nullptr && !timedOut->cpu) || std::holds_alternative<BoxStarved>(end);
    case End::Memory:
        return level() == SandboxLevel::S3 ? std::holds_alternative<BoxOutOfMemory>(end) : tried;
    case End::Log:
        return std::holds_alternative<BoxLogTooLarge>(end);
    default:
        return !std::holds_alternative<BoxNotStarted>(end);
    }
}

/// Asked to double two numbers. What it does beside must not have given it anything.
Seen Judge::judgeProbe(const Attack &attack) const {
    protocol::RequestGroup group;
    group.files = {{attack.name, ""}};
    for (const float u : {0.25F, 0.5F}) {
        protocol::Request request;
        request.text = "triangle";
        request.values = {u, 0.125F};
        group.requests.push_back(request);
    }
    BoxLimits limits;
    limits.cpu = std::chrono::seconds(1);
    limits.wall = std::chrono::milliseconds(1500);
    const ProbeAnswer answer = askProbe(m_sandbox, programOf(attack), group, limits);
    if (answer.outcome.log.find("GOT") != std::string::npos)
        return {false, safeLine(answer.outcome.log.substr(0, 60))};
    const std::string &fds = answer.outcome.log;
    if (isNamed(attack, "lists_descriptors") && fds != "0 1 2 3 4 ")
        return {false, "has descriptors " + fds};
    std::size_t right = 0;
    for (std::size_t i = 0; i < group.requests.size(); ++i) {
        const std::vector<float> &asked = group.requests[i].values;
        const protocol::Response &response = answer.responses[i];
        if (response.message.size() > 2000)
            return {false, "A MESSAGE BEYOND ITS LIMIT"};
        right += response.values == std::vector<float>{2 * asked[0], 2 * asked[1]} ? 1U : 0U;
    }
    const bool answers = isNamed(attack, "attacks_memory") || isNamed(attack, "keeps_changing");
    return {answers || right == 0,
            fmt::format("{} of 2 answers right; {}", right, describe(answer.outcome.end)),
            m_quick ? 0 : m_marks.pointsFor(ask(attack))};
}

/// Judged by the checks of the grader itself.
Seen Judge::judgeCheat(const Attack &attack) const {
    const std::vector<CheckResult> checks = ask(attack);
    const std::string claim = attack.claim != nullptr ? attack.claim : "warp.disk.samples";
    Seen seen;
    for (const CheckResult &check : checks) {
        seen.what += (seen.what.empty() ? "" : ", ") + std::string(verdictName(check.verdict));
        if (check.id == claim)
            seen.contained = check.verdict != Verdict::Pass && check.verdict != Verdict::Infra;
        if (safeLine(check.message).find('\x1b') != std::string::npos)
            return {false, "AN ESCAPE IN A MESSAGE"};
    }
    const double points = m_marks.pointsFor(checks);
    const double honest = attack.claim != nullptr ? m_marks.pointsWithout(claim, checks) : 0;
    seen.gained = points - honest;
    if (honest > 0)
        seen.what += fmt::format("; {:g} points for its honest part", honest);
    return seen;
}

/// Built as the only file of a hand-in; what comes of it is asked for the disk.
Seen Judge::judgeSource(const Attack &attack) const {
    const std::string before =
        attack.kind == Kind::HandIn ? starterBase().units.at("warp.cpp") + "\n" : std::string();
    const std::string text = before + attackSource(attack.name, m_host.secretFile().string()) +
                             fmt::format("// {} {}\n", sandboxLevelName(level()), m_run);
    const Cache cache;
    Compiler compiler(m_sandbox, cache);
    Submission submission;
    submission.files = {{"src/warp.cpp", "warp.cpp", FileRole::Source, "", text}};
    VariantBuilder builder(compiler, submission, 1);
    const auto failure = builder.failureOf("warp.cpp");
    Variant variant;
    if (!failure)
        variant = builder.build(studentPlan(findGroup("warp")));
    std::string product = failure ? failure->describe() : std::string();
    for (const BuildFailure &each : variant.failures)
        product += each.describe();
    if (variant.executable)
        product += wholeFile(*variant.executable);
    if (product.find(kSecret) != std::string::npos)
        return {false, "READ THE SECRET"};
    if (product.find(Cache::defaultRoot().string()) != std::string::npos)
        return {false, "KNOWS WHERE IT LIES"};
    // Else there is nothing in the program that could have known more.
    if (isNamed(attack, "names_its_machine") &&
        product.find("lies in src/warp.cpp of src/warp.cpp of ") == std::string::npos)
        return {false, "does not say where it lies"};
    const bool linked = attack.kind == Kind::Source || variant.executable;
    Seen seen{attack.end == End::Any ||
                  (attack.end == End::Failed ? failure.has_value() : !failure && linked),
              failure ? safeLine(product).substr(0, 70) : "compiles"};
    if (variant.executable) {
        NamedContext context(m_sandbox, *variant.executable, attack.name, BoxLimits());
        seen.gained = m_marks.pointsFor(m_marks.check(context));
        seen.what += fmt::format(", {:g} points", seen.gained);
    } else {
        seen.gained = m_marks.pointsFor(Verdict::BuildError);
        seen.what += failure ? "" : ", but does not link";
    }
    return seen;
}

Seen Judge::run(const test::HostileArchive &archive) {
    const fs::path file = m_host.inbox() / "p2_111111_222222.zip";
    std::ofstream(file, std::ios::binary) << archive.make();
    const fs::path workingFolder = fs::current_path();
    fs::current_path(file.parent_path());
    const Seen seen = watched([&] { return judgeArchive(archive); });
    fs::current_path(workingFolder);
    fs::remove(file);
    return seen;
}

Seen Judge::judgeArchive(const test::HostileArchive &archive) const {
    const test::ReadArchive read =
        readHostileArchive(archive, fs::current_path() / "p2_111111_222222.zip");
    if (!read.fault.empty())
        return {false, safeLine(read.fault)};
    if (!read.error.empty())
        return {true, "refused: " + std::string(archive.refused)};
    const auto used =
        std::count_if(read.submission.files.begin(), read.submission.files.end(),
                      [](const SubmittedFile &file) { return file.role != FileRole::Ignored; });
    return {true, fmt::format("{} of {} files used", used, read.submission.files.size()),
            m_marks.pointsFor(read.submission)};
}

} // namespace attack
