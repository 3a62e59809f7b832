// SPDX-License-Identifier: MIT
//
// `./run endurance`: starts boxes and ends them, and kills graders at random moments after they
// have started one, at both levels; then looks for what is left.
#include <grader/sandbox/orphans.h>
#include <grader/sandbox/supervisor.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

#include "../grading/grader/sandbox/hostile_box.h"
#include <exam/summary.h>

namespace {

using namespace grader;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::chrono::seconds kHang(120); ///< a launch that takes longer is one
/// For the guards of killed graders, which look out for 2 s of their own time, all at once.
constexpr milliseconds kPatience(120'000);
constexpr int kMostDelay = 50'000; ///< of a kill after the launch [us]

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What was seen at one level.
struct Outcome {
    int launches = 0, wrongEnds = 0, processesLeft = 0, groupsLeft = 0;
    long descriptorsMore = 0;
    long memoryMore = 0;                     ///< resident [KiB]
    double median = 0, p99 = 0, longest = 0; ///< of a launch, from start to everything gone [ms]
    double load = 0; ///< processes that wanted a core meanwhile, ours among them
    int kills = 0, livedOn = 0, survivors = 0, groupsAfterKills = 0, processesAfterKills = 0;

    bool isWell() const {
        return wrongEnds == 0 && processesLeft == 0 && groupsLeft == 0 && descriptorsMore == 0 &&
               livedOn == 0 && survivors == 0 && groupsAfterKills == 0 && processesAfterKills == 0;
    }
};

/// Resident memory of this process [KiB].
long residentMemory() {
    std::ifstream lines("/proc/self/status");
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("VmRSS:", 0) == 0)
            return std::atol(line.c_str() + 6);
    }
    return 0;
}

void showProgress(const char *what, int done, int all, Clock::time_point start) {
    if (::isatty(STDERR_FILENO) == 0)
        return;
    const double left = secondsSince(start) * (all - done) / done;
    fmt::print(stderr, "\r{} {} of {}, {:.0f} s left   {}", what, done, all, left,
               done == all ? "\n" : "");
}

double quantile(std::vector<double> values, double fraction) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
}

class Endurance {
public:
    Endurance(SandboxLevel level, const char *program) : m_sandbox(level) {
        std::string pattern = "/tmp/norigrade-endurance-XXXXXX";
        if (::mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error("no temporary folder");
        m_folder = pattern;
        ::chmod(m_folder.c_str(), 0755);
        m_marker = m_folder.filename().string();
        std::ofstream(m_folder / "sentinel") << "untouched";
        m_program = m_folder / "hostile";
        std::filesystem::copy_file(program, m_program);
        if (m_sandbox.level() != level)
            throw std::runtime_error(fmt::format("this machine gives {}, not {}",
                                                 sandboxLevelName(m_sandbox.level()),
                                                 sandboxLevelName(level)));
    }

    ~Endurance() { std::filesystem::remove_all(m_folder); }

    Endurance(const Endurance &) = delete;
    Endurance &operator=(const Endurance &) = delete;
    Endurance(Endurance &&) = delete;
    Endurance &operator=(Endurance &&) = delete;

    SandboxLevel level() const { return m_sandbox.level(); }

    void launch(int count, Outcome &seen) {
        const BoxSpec spec = hostileSpec(m_program, "exit_with_seven", m_marker);
        std::vector<double> times;
        std::vector<double> loads;
        m_sandbox.run(spec);
        const long descriptors = openDescriptors();
        const long memory = residentMemory();
        const auto begin = Clock::now();
        for (int i = 1; i <= count; ++i) {
            ::alarm(kHang.count()); // ends this program: a hang is nothing to go on after
            const auto start = Clock::now();
            const BoxOutcome outcome = m_sandbox.run(spec);
            times.push_back(1000 * secondsSince(start));
            const auto *exited = std::get_if<BoxExited>(&outcome.end);
            if (exited == nullptr || exited->code != 7) {
                ++seen.wrongEnds;
                fmt::print("launch {}: {}\n", i, describe(outcome.end));
            }
            if (i % 100 != 0 && i != count)
                continue;
            showProgress("launches", i, count, begin);
            double load = 0;
            ::getloadavg(&load, 1);
            loads.push_back(load);
        }
        ::alarm(0);
        seen.launches = count;
        seen.median = quantile(times, 0.5);
        seen.p99 = quantile(times, 0.99);
        seen.longest = quantile(times, 1);
        seen.load = quantile(loads, 0.5);
        seen.memoryMore = residentMemory() - memory;
        seen.descriptorsMore = openDescriptors() - descriptors;
        seen.processesLeft = processesMarked(m_marker) + (hasChild() ? 1 : 0);
        seen.groupsLeft = controlGroupsOf(::getpid());
    }

    void kill(int count, Outcome &seen) {
        std::mt19937 random(std::random_device{}());
        const BoxSpec spec = hostileSpec(m_program, "rest", m_marker);
        std::vector<pid_t> graders;
        const auto begin = Clock::now();
        for (int i = 1; i <= count; ++i) {
            const pid_t process = ::fork();
            if (process == 0) {
                m_sandbox.run(spec);
                ::_exit(0);
            }
            graders.push_back(process);
            std::this_thread::sleep_for(std::chrono::microseconds(random() % kMostDelay));
            ::kill(process, SIGKILL);
            ::waitpid(process, nullptr, 0);
            if (!boxesEnd(milliseconds(1000))) {
                ++seen.livedOn;
                killOrphans(); // what a grader does when it starts
                seen.survivors += boxesEnd(milliseconds(1000)) ? 0 : 1;
            }
            if (i % 10 == 0 || i == count)
                showProgress("kills", i, count, begin);
        }
        const bool alone = within(kPatience, [] { return !hasChild(); });
        const Sandbox next(m_sandbox.level()); // removes the control groups of those that died
        for (const pid_t grader : graders)
            seen.groupsAfterKills += controlGroupsOf(grader);
        seen.kills = count;
        seen.processesAfterKills = alone ? 0 : 1;
    }

private:
    /// Waits until nothing of a box is there. \return  false if something is for longer
    bool boxesEnd(milliseconds patience) const {
        return within(patience, [&] { return processesMarked(m_marker) == 0; });
    }

    /// Orphans become our children, so that none escapes unseen.
    template <typename Holds>
    static bool within(milliseconds patience, const Holds &holds) {
        for (const auto end = Clock::now() + patience; Clock::now() < end;) {
            while (::waitpid(-1, nullptr, WNOHANG) > 0) {
            }
            if (holds())
                return true;
            std::this_thread::sleep_for(milliseconds(2));
        }
        return false;
    }

    Sandbox m_sandbox;
    std::filesystem::path m_folder;
    std::filesystem::path m_program;
    std::string m_marker;
};

std::string describe(SandboxLevel level, const Outcome &seen) {
    std::string text;
    if (seen.kills > 0)
        text += fmt::format(
            "{}: {} graders killed 0 to {} ms after a launch: {} boxes lived on for more than a "
            "second, {} after the sweep of the next start; {} control groups and {} processes "
            "left\n",
            sandboxLevelName(level), seen.kills, kMostDelay / 1000, seen.livedOn, seen.survivors,
            seen.groupsAfterKills, seen.processesAfterKills);
    if (seen.launches > 0)
        text += fmt::format(
            "{}: {} launches: 0 hangs, {} wrong ends; median {:.1f} ms, p99 {:.1f} ms, longest "
            "{:.1f} ms at a load of {:.1f} on {} cores; {} descriptors and {} KiB more than "
            "before, {} processes and {} control "
            "groups left\n",
            sandboxLevelName(level), seen.launches, seen.wrongEnds, seen.median, seen.p99,
            seen.longest, seen.load, std::thread::hardware_concurrency(), seen.descriptorsMore,
            seen.memoryMore, seen.processesLeft, seen.groupsLeft);
    return text;
}

struct Options {
    int launches = 10'000;
    int kills = 300;
    std::string level; ///< empty: both
    std::string record;
    std::string commit;
};

int endure(const Options &options) {
    bool isWell = true;
    for (const SandboxLevel level : {SandboxLevel::S3, SandboxLevel::S2}) {
        const std::string name = sandboxLevelName(level);
        if (!options.level.empty() && options.level != name)
            continue;
        Endurance endurance(level, HOSTILE);
        Outcome seen;
        endurance.kill(options.kills, seen);
        endurance.launch(options.launches, seen);
        const std::string text = describe(level, seen);
        fmt::print("{}", text);
        std::fflush(stdout);
        isWell = isWell && seen.isWell();
        std::string section = fmt::format("Measured at commit `{}`.\n\n", options.commit);
        std::istringstream stream(text);
        for (std::string line; std::getline(stream, line);)
            section += "- " + line + "\n";
        if (!options.record.empty())
            exam::replaceSection(options.record, "endurance " + name, section);
    }
    return isWell ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("Starts and ends boxes, and kills graders just after they have started one; "
                 "nothing may be left.\nExit codes: 0 all is well, 1 not all, 2 usage, 4 the "
                 "machine does not give the level.",
                 "./run endurance");
    app.add_option("--launches", options.launches, "Boxes that are started at each level")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    app.add_option("--kills", options.kills, "Graders that are killed at each level")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    app.add_option("--level", options.level, "Only this level")->check(CLI::IsMember({"S2", "S3"}));
    CLI::Option *record =
        app.add_option("--record", options.record, "Write the figures into this Markdown file")
            ->option_text("FILE");
    app.add_option("--commit", options.commit, "What is measured, for the table")->needs(record);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        return endure(options);
    } catch (const std::exception &error) {
        fmt::print(stderr, "endurance: {}\n", error.what());
        return 4;
    }
}
