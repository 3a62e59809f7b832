// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <viewer/report.h>

namespace viewer {

/// One thing to do for one subject.
struct Job {
    enum class Kind { Test, Save } kind = Kind::Test;
    Subject subject;
    Settings settings;
};

/// Works off jobs in one thread, so that the window never waits. All functions are for the
/// window's thread.
class Runner {
public:
    /// \param wake  called from the worker when there is something new to show
    Runner(Actions actions, std::function<void()> wake);
    /// Cancels and waits.
    ~Runner();
    Runner(const Runner &) = delete;
    Runner &operator=(const Runner &) = delete;
    Runner(Runner &&) = delete;
    Runner &operator=(Runner &&) = delete;

    /// Does nothing while it is busy.
    void start(std::vector<Job> jobs);
    void cancel();

    [[nodiscard]] bool isBusy() const { return m_busy; }

    /// Of all jobs, in [0, 1].
    [[nodiscard]] double progress() const { return m_progress; }

    /// What is done, was saved, or went wrong.
    [[nodiscard]] std::string status() const;

    /// The last report of a subject (index into the subjects), or null.
    [[nodiscard]] std::shared_ptr<const TestReport> report(std::size_t warp) const;

private:
    void work(const std::vector<Job> &jobs);
    void runTest(const Job &job, const TestControl &control);
    void say(std::string text);

    Actions m_actions;
    std::function<void()> m_wake;
    std::thread m_thread;
    std::atomic<bool> m_busy{false};
    std::atomic<bool> m_cancelled{false};
    std::atomic<double> m_progress{0.0};
    mutable std::mutex m_mutex; ///< of what follows
    std::string m_status;
    std::map<std::size_t, std::shared_ptr<const TestReport>> m_reports;
};

} // namespace viewer
