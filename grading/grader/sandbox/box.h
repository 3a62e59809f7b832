// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace grader {

/// Where this process may make control groups of its own, for memory and for process counts.
struct CgroupPlaces {
    std::filesystem::path memory; ///< empty: not writable
    std::filesystem::path pids;
    bool version2 = false; ///< of the kernel's interface

    bool complete() const { return !memory.empty() && !pids.empty(); }
};

/// How strongly this machine can lock a process in (weakest first); see grading/README.md.
enum class SandboxLevel { S0, S1, S2, S3 };
const char *sandboxLevelName(SandboxLevel level);

struct BoxLimits {
    std::chrono::milliseconds cpu{20'000}; ///< of each process, rounded up to seconds
    std::chrono::milliseconds wall{60'000};
    std::uint64_t memoryBytes = std::uint64_t{2} << 30;
    std::uint64_t fileBytes = std::uint64_t{64} << 20; ///< largest file it may write
    std::uint64_t logBytes = std::uint64_t{1}
                             << 20; ///< of stdout and stderr together, then it is killed
    std::uint64_t temporaryBytes = std::uint64_t{256} << 20; ///< of its private /tmp
    std::uint32_t processes = 64;                            ///< with threads
};

/// A host path that is visible in the box.
struct BoxBind {
    std::filesystem::path host;
    std::string inside;
    bool writable = false;
};

/// An untrusted process to run. Besides `binds` it sees the system's libraries (compilers: all of
/// /usr but /usr/local; read-only), a small private /tmp and nothing else: no network, no /proc, no
/// environment, no other process.
struct BoxSpec {
    std::vector<std::string> argv;
    std::vector<BoxBind> binds;
    std::string workingFolder = "/tmp";
    BoxLimits limits;
    bool mayFork = false;         ///< compilers do; probes do not
    std::vector<int> descriptors; ///< inherited as 3, 4, ...; everything else is closed
};

// The ways in which a boxed process can end. Each is an expected fact about a submission.
struct BoxExited {
    int code = 0; ///< says nothing about the answer the process gave
};

struct BoxSignalled {
    int signal = 0;
};

struct BoxTimedOut {
    bool cpu = false; ///< CPU limit; else wall clock
};

/// The wall clock ran out on a process that had waited for a processor for most of the time: the
/// machine's fault (Infra), never the submission's.
struct BoxStarved {
    double waited = 0; ///< seconds
};

struct BoxOutOfMemory {};

struct BoxLogTooLarge {};

struct BoxNotStarted {
    std::string reason; ///< our own failure (Infra), never the submission's
};

using BoxEnd = std::variant<BoxExited, BoxSignalled, BoxTimedOut, BoxStarved, BoxOutOfMemory,
                            BoxLogTooLarge, BoxNotStarted>;

struct BoxOutcome {
    BoxEnd end;
    std::string log;       ///< stdout and stderr as they came, capped
    double cpuSeconds = 0; ///< user + system
    double wallSeconds = 0;
};

/// Why it is our own failure, if it is: then nothing can be said of the submission. Else empty.
std::string ownFailure(const BoxEnd &end);

/// One sentence on how a process ended, for reports.
std::string describe(const BoxEnd &end);

/// Runs untrusted processes at the strongest level that this machine gives. Thread-safe. When run()
/// returns, the process and everything it started is gone.
class Sandbox {
public:
    /// Probes the machine. \param wanted  refuse to use more than this level (for tests)
    explicit Sandbox(SandboxLevel wanted = SandboxLevel::S3);

    SandboxLevel level() const { return m_level; }

    /// What was tried and found, one line per feature: what `norigrade doctor` prints.
    const std::vector<std::string> &findings() const { return m_findings; }

    /// \throws GraderError  if the level is below S2: then nothing is run
    BoxOutcome run(const BoxSpec &spec) const;

private:
    /// Runs a harmless program with all that a submission's box will have.
    /// \return  what went wrong; empty if nothing did
    std::string tryOut(SandboxLevel level);

    SandboxLevel m_level = SandboxLevel::S0;
    std::vector<std::string> m_findings;
    CgroupPlaces m_cgroups;
};

} // namespace grader
