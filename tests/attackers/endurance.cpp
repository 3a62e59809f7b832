// SPDX-License-Identifier: MIT
//
// `./run endurance [--launches N] [--kills K] [--level S2|S3]`: starts boxes and ends them, and
// kills graders at random moments after they have started one; then looks for what is left.
#include <grader/sandbox/orphans.h>
#include <grader/sandbox/supervisor.h>

#include <fmt/core.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

#include "../grading/grader/sandbox/hostile_box.h"

namespace {

using namespace grader;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::chrono::seconds kHang(120); ///< a launch that takes longer is one
constexpr int kMostDelay = 50'000;         ///< of a kill after the launch [us]

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void showProgress(const char *what, int done, int all, Clock::time_point start) {
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

    /// \return  true if all is well
    bool launch(int count) {
        const BoxSpec spec = hostileSpec(m_program, "exit_with_seven", m_marker);
        std::vector<double> times;
        int wrong = 0;
        m_sandbox.run(spec);
        const long descriptors = openDescriptors();
        const auto begin = Clock::now();
        for (int i = 1; i <= count; ++i) {
            ::alarm(kHang.count()); // ends this program: a hang is nothing to go on after
            const auto start = Clock::now();
            const BoxOutcome outcome = m_sandbox.run(spec);
            times.push_back(1000 * secondsSince(start));
            const auto *exited = std::get_if<BoxExited>(&outcome.end);
            if (exited == nullptr || exited->code != 7) {
                ++wrong;
                fmt::print("launch {}: {}\n", i, describe(outcome.end));
            }
            if (i % 100 == 0 || i == count)
                showProgress("launches", i, count, begin);
        }
        ::alarm(0);
        const long more = openDescriptors() - descriptors;
        const int left = processesMarked(m_marker) + (hasChild() ? 1 : 0);
        const int groups = controlGroupsOf(::getpid());
        fmt::print("{} launches at {}: 0 hangs, {} wrong ends, median {:.1f} ms, p99 {:.1f} ms, "
                   "longest {:.1f} ms; {} descriptors more than before, {} processes and {} "
                   "control groups left\n",
                   count, sandboxLevelName(m_sandbox.level()), wrong, quantile(times, 0.5),
                   quantile(times, 0.99), quantile(times, 1), more, left, groups);
        return wrong == 0 && more == 0 && left == 0 && groups == 0;
    }

    bool kill(int count) {
        std::mt19937 random(std::random_device{}());
        const BoxSpec spec = hostileSpec(m_program, "rest", m_marker);
        int lived = 0;
        int survivors = 0;
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
                ++lived;
                killOrphans(); // what a grader does when it starts
                survivors += boxesEnd(milliseconds(1000)) ? 0 : 1;
            }
            if (i % 10 == 0 || i == count)
                showProgress("kills", i, count, begin);
        }
        const bool alone = within(milliseconds(10'000), [] { return !hasChild(); });
        const Sandbox next(m_sandbox.level()); // removes the control groups of those that died
        int groups = 0;
        for (const pid_t grader : graders)
            groups += controlGroupsOf(grader);
        fmt::print("{} graders killed 0 to {} ms after the launch at {}: {} boxes lived on for "
                   "more than a second, {} after the sweep of the next start; {} control groups "
                   "and {} processes left\n",
                   count, kMostDelay / 1000, sandboxLevelName(m_sandbox.level()), lived, survivors,
                   groups, alone ? "no" : "some");
        return lived == 0 && survivors == 0 && groups == 0 && alone;
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

} // namespace

int main(int argc, char **argv) {
    int launches = 10'000;
    int kills = 300;
    SandboxLevel level = SandboxLevel::S3;
    for (int i = 1; i < argc; i += 2) {
        const std::string option = argv[i];
        const std::string value = i + 1 < argc ? argv[i + 1] : "";
        const int count = std::atoi(value.c_str());
        if (option == "--launches" && (count > 0 || value == "0"))
            launches = count;
        else if (option == "--kills" && (count > 0 || value == "0"))
            kills = count;
        else if (option == "--level" && (value == "S2" || value == "S3"))
            level = value == "S2" ? SandboxLevel::S2 : SandboxLevel::S3;
        else {
            fmt::print(stderr,
                       "endurance: \"{} {}\": known are --launches N, --kills K, --level S2|S3\n",
                       option, value);
            return 2;
        }
    }
    try {
        Endurance endurance(level, HOSTILE);
        const bool killed = kills == 0 || endurance.kill(kills);
        const bool launched = launches == 0 || endurance.launch(launches);
        return killed && launched ? 0 : 1;
    } catch (const std::exception &error) {
        fmt::print(stderr, "endurance: {}\n", error.what());
        return 4;
    }
}
