// SPDX-License-Identifier: MIT
//
// `./run attack [--level S2|S3] [--quick] [NAME...]`: runs every attacker of the table at both
// levels and prints what was seen. Exits with 1 if one has gained or left something.
#include <grader/build/compiler.h>
#include <grader/checks/check.h>
#include <grader/digest.h>
#include <grader/results/safe_text.h>

#include <fmt/core.h>

#include <cstdlib>
#include <cstring>
#include <set>

#include "../grading/grader/sandbox/hostile_box.h"
#include "attack.h"

namespace {

using namespace grader;
using attack::Attack;
using attack::End;
using attack::Kind;
namespace fs = std::filesystem;

constexpr char kSecret[] = "secret 3141592653";

/// Whether it was contained, and in a few words how that was seen.
struct Seen {
    bool contained = false;
    std::string what;
};

/// Puts a name before everything that is asked of a cheat, and asks it in the box.
class CheatContext : public CheckContext {
public:
    CheatContext(const Sandbox &sandbox, fs::path program, std::string name)
        : m_sandbox(sandbox), m_program(std::move(program)), m_name(std::move(name)) {}

    ProbeAnswer ask(const protocol::RequestGroup &group) override {
        protocol::RequestGroup named = group;
        named.files.insert(named.files.begin(), {m_name, ""});
        BoxLimits limits;
        limits.cpu = std::chrono::seconds(3);
        limits.wall = std::chrono::seconds(30);
        limits.memoryBytes = std::uint64_t{512} << 20U;
        return askProbe(m_sandbox, m_program, named, limits);
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
};

class Exam {
public:
    explicit Exam(SandboxLevel level) : m_sandbox(level) {
        std::string pattern = "/tmp/norigrade-attack-XXXXXX";
        if (::mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error("no temporary folder");
        m_folder = pattern;
        ::chmod(m_folder.c_str(), 0755);
        m_marker = m_folder.filename().string();
        for (const char *file : {"sentinel", "tree/secret", "tree/grades/results.json"}) {
            fs::create_directories((m_folder / file).parent_path());
            std::ofstream(m_folder / file) << kSecret << "\n";
            ::chmod((m_folder / file).c_str(), 0666);
        }
        for (const char *program : {HOSTILE, ESCAPES, HOSTILE_PROBE, CHEATS})
            fs::copy_file(program, place(program));
    }

    ~Exam() { fs::remove_all(m_folder); }

    Exam(const Exam &) = delete;
    Exam &operator=(const Exam &) = delete;
    Exam(Exam &&) = delete;
    Exam &operator=(Exam &&) = delete;

    SandboxLevel level() const { return m_sandbox.level(); }

    /// Runs one, then looks for traces.
    Seen run(const Attack &attack) {
        const std::string files = digestOfFiles();
        const std::string mounts = wholeFile("/proc/self/mountinfo");
        const long descriptors = openDescriptors();
        Seen seen = start(attack);
        const auto trace = [&](bool found, const char *what) {
            if (found)
                seen = {false, std::string(what) + "; " + seen.what};
        };
        trace(processesMarked(m_marker) > 0 || hasChild(), "LEFT A PROCESS");
        trace(controlGroupsOf(::getpid()) > 0, "LEFT A CONTROL GROUP");
        trace(wholeFile("/proc/self/mountinfo") != mounts, "LEFT A MOUNT");
        trace(openDescriptors() != descriptors, "LEFT A DESCRIPTOR");
        trace(digestOfFiles() != files, "CHANGED A FILE");
        return seen;
    }

    /// The same checks pass what does not cheat.
    bool honestPasses() {
        return judgeCheat({'E', Kind::Cheat, "honest", "", End::Any}).what == "pass, pass, pass";
    }

private:
    fs::path place(const fs::path &program) const { return m_folder / program.filename(); }

    /// Of names, contents, rights and times below the sentinel tree.
    std::string digestOfFiles() const {
        std::string all;
        std::set<fs::path> files{m_folder / "sentinel"};
        for (const auto &entry : fs::recursive_directory_iterator(m_folder / "tree"))
            files.insert(entry.path());
        for (const fs::path &file : files) {
            struct stat status {};

            ::stat(file.c_str(), &status);
            all += fmt::format("{} {} {} {} {}\n", file.string(), status.st_mode, status.st_uid,
                               status.st_mtime,
                               fs::is_regular_file(file) ? wholeFile(file) : std::string());
        }
        return sha256Hex(all);
    }

    Seen start(const Attack &attack) {
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
            return judgeSource(attack);
        }
        return {};
    }

    Seen judgeProcess(const Attack &attack) {
        const bool escape =
            attack.kind == Kind::Escape || std::strcmp(attack.name, "tries_rare_calls") == 0;
        BoxSpec spec = hostileSpec(place(escape ? ESCAPES : HOSTILE), attack.name, m_marker);
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
        return {endsAs(attack.end, outcome.end), describe(outcome.end)};
    }

    bool endsAs(End wanted, const BoxEnd &end) const {
        const auto *timedOut = std::get_if<BoxTimedOut>(&end);
        switch (wanted) {
        case End::Exit:
            return std::holds_alternative<BoxExited>(end);
        case End::Signal:
            return std::holds_alternative<BoxSignalled>(end);
        case End::Cpu:
            return timedOut != nullptr && timedOut->cpu;
        case End::Wall:
            return timedOut != nullptr && !timedOut->cpu;
        case End::Memory:
            return level() == SandboxLevel::S3 ? std::holds_alternative<BoxOutOfMemory>(end)
                                               : std::holds_alternative<BoxExited>(end);
        case End::Log:
            return std::holds_alternative<BoxLogTooLarge>(end);
        default:
            return !std::holds_alternative<BoxNotStarted>(end);
        }
    }

    /// Asked to double two numbers. What it does beside must not have given it anything.
    Seen judgeProbe(const Attack &attack) {
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
        const ProbeAnswer answer = askProbe(m_sandbox, place(HOSTILE_PROBE), group, limits);
        if (answer.outcome.log.find("GOT") != std::string::npos)
            return {false, safeLine(answer.outcome.log.substr(0, 60))};
        const std::string fds = answer.outcome.log;
        if (std::strcmp(attack.name, "lists_descriptors") == 0 && fds != "0 1 2 3 4 ")
            return {false, "has descriptors " + fds};
        const bool answers = std::strcmp(attack.name, "attacks_memory") == 0 ||
                             std::strcmp(attack.name, "keeps_changing") == 0;
        std::size_t right = 0;
        for (std::size_t i = 0; i < group.requests.size(); ++i) {
            const std::vector<float> &asked = group.requests[i].values;
            const protocol::Response &response = answer.responses[i];
            if (response.message.size() > 2000)
                return {false, "A MESSAGE BEYOND ITS LIMIT"};
            right += response.values == std::vector<float>{2 * asked[0], 2 * asked[1]} ? 1U : 0U;
        }
        return {answers || right == 0,
                fmt::format("{} of 2 answers right; {}", right, describe(answer.outcome.end))};
    }

    /// Judged by the checks of the grader itself.
    Seen judgeCheat(const Attack &attack) {
        const std::string name = attack.name;
        const std::string attacked = name == "remembers_where_it_was_asked" ? "warp.disk.density"
                                     : name == "density_everywhere"         ? "warp.disk.outside"
                                                                            : "warp.disk.samples";
        Seen seen;
        for (const char *id : {"warp.disk.samples", "warp.disk.density", "warp.disk.outside"}) {
            CheatContext context(m_sandbox, place(CHEATS), name);
            const CheckResult result = findCheck(id)->run(context);
            seen.what += (seen.what.empty() ? "" : ", ") + std::string(verdictName(result.verdict));
            if (id == attacked)
                seen.contained =
                    result.verdict != Verdict::Pass && result.verdict != Verdict::Infra;
            if (safeLine(result.message).find('\x1b') != std::string::npos)
                return {false, "AN ESCAPE IN A MESSAGE"};
        }
        return seen;
    }

    Seen judgeSource(const Attack &attack) {
        const Cache cache(m_cache);
        Compiler compiler(m_sandbox, cache);
        const fs::path secret = m_folder / "tree" / "secret";
        const std::string text = attack::attackSource(attack.name, secret.string()) +
                                 fmt::format("// {}\n", sandboxLevelName(level()));
        const Built built = compiler.compile({"warp.cpp", "src/warp.cpp", text}, {});
        const auto *failure = std::get_if<BuildFailure>(&built);
        const std::string product =
            failure != nullptr ? failure->describe() : wholeFile(std::get<fs::path>(built));
        if (product.find(kSecret) != std::string::npos)
            return {false, "READ THE SECRET"};
        if (product.find(m_cache.string()) != std::string::npos)
            return {false, "KNOWS WHERE IT LIES"};
        const bool expected =
            attack.end == End::Any || (attack.end == End::Failed) == (failure != nullptr);
        return {expected, failure != nullptr ? safeLine(product).substr(0, 70) : "compiles"};
    }

    Sandbox m_sandbox;
    fs::path m_folder;
    fs::path m_cache = fs::temp_directory_path() / "norigrade-attack-cache"; ///< what is common
    std::string m_marker;
};

constexpr int kSkipped = 77; ///< for CTest

bool isQuick(const Attack &attack) {
    return attack.kind != Kind::Hostile && attack.kind != Kind::Source && attack.group != 'E';
}

/// \return  how many were not contained
int runAll(SandboxLevel level, bool quick, const std::vector<std::string> &names) {
    Exam exam(level);
    if (exam.level() != level)
        throw std::runtime_error(
            fmt::format("this machine gives {}, not {}; see `norigrade doctor`",
                        sandboxLevelName(exam.level()), sandboxLevelName(level)));
    int escaped = 0;
    int count = 0;
    if (!exam.honestPasses()) {
        fmt::print("{}: the honest program does not pass the checks\n", sandboxLevelName(level));
        ++escaped;
    }
    for (const Attack &attack : attack::attackTable()) {
        const bool wanted =
            names.empty() || std::find(names.begin(), names.end(), attack.name) != names.end();
        if (!wanted || (quick && !isQuick(attack)) || level < attack.contained)
            continue;
        const Seen seen = exam.run(attack);
        ++count;
        escaped += seen.contained ? 0 : 1;
        fmt::print("{} {} {:<29} {:<46} {} {}\n", sandboxLevelName(level), attack.group,
                   attack.name, attack.tries,
                   seen.contained ? "contained:" : "NOT CONTAINED:", seen.what);
        std::fflush(stdout);
    }
    fmt::print("{}: {} attackers, {} not contained\n", sandboxLevelName(level), count, escaped);
    return escaped + (count == 0 ? 1 : 0);
}

} // namespace

int main(int argc, char **argv) {
    std::vector<SandboxLevel> levels{SandboxLevel::S3, SandboxLevel::S2};
    std::vector<std::string> names;
    bool quick = false;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--quick") {
            quick = true;
        } else if (argument == "--level" && i + 1 < argc &&
                   (argv[i + 1] == std::string("S2") || argv[i + 1] == std::string("S3"))) {
            levels = {argv[++i] == std::string("S2") ? SandboxLevel::S2 : SandboxLevel::S3};
        } else if (argument.rfind("--", 0) == 0) {
            fmt::print(stderr, "attack: \"{}\": known are --level S2|S3, --quick, and names\n",
                       argument);
            return 2;
        } else {
            names.push_back(argument);
        }
    }
    try {
        int escaped = 0;
        for (const SandboxLevel level : levels)
            escaped += runAll(level, quick, names);
        return escaped == 0 ? 0 : 1;
    } catch (const std::exception &error) {
        fmt::print(stderr, "attack: {}\n", error.what());
        // An ordinary user's machine often has no control groups; one that tests for all must.
        return quick && std::getenv("CI") == nullptr ? kSkipped : 4;
    }
}
