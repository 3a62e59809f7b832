// SPDX-License-Identifier: MIT
#include "grading_queue.h"

#include <fmt/format.h>

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

#include "command.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

std::atomic<bool> interrupted = false; // NOLINT: a signal can reach nothing else

/// What is left to do, in one line of the terminal.
class Progress {
public:
    explicit Progress(std::size_t tasks)
        : m_tasks(tasks),
          m_start(std::chrono::steady_clock::now()),
          m_terminal(isatty(STDERR_FILENO) != 0) {}

    void clear() const {
        if (m_terminal)
            std::cerr << "\r\x1b[K" << std::flush;
    }

    void add(bool isNew) {
        ++m_done;
        m_new += isNew ? 1 : 0;
        if (!m_terminal || m_new == 0)
            return;
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
        const double left =
            seconds / static_cast<double>(m_new) * static_cast<double>(m_tasks - m_done);
        std::cerr << fmt::format("{} of {}, {:.0f} min left", m_done, m_tasks, left / 60)
                  << std::flush;
    }

    std::size_t done() const { return m_done; }

private:
    std::size_t m_tasks;
    std::size_t m_done = 0, m_new = 0;
    std::chrono::steady_clock::time_point m_start;
    bool m_terminal;
};

/// `disk/no_root --item warp.disk --seed ...`
std::string describe(const GradingTask &task) {
    return fmt::format("{}{} --seed {}{}", task.name,
                       task.question.item.empty() ? "" : " --item " + task.question.item,
                       task.question.seed,
                       task.processes > 1 ? fmt::format(" --jobs {}", task.processes) : "");
}

} // namespace

std::string describeSetAside(const std::vector<std::string> &names) {
    if (names.empty())
        return "";
    return fmt::format("\nSet aside, because the grader itself failed {} times:\n\n- {}\n", kTries,
                       fmt::join(names, "\n- "));
}

void catchInterrupts() {
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, [](int) { interrupted = true; });
}

bool isInterrupted() {
    return interrupted;
}

GradingQueue::GradingQueue(const GradingPlaces &places, int atOnce)
    : m_norigrade(places.norigrade),
      m_atOnce(atOnce),
      m_cache(places.cache,
              {places.norigrade, places.project / "renderer", places.project / "grading" / "probe",
               places.project / "grading" / "protocol", places.project / "grading" / "rubrics",
               places.project / "scenes" / "grading",
               places.project / "scenes" / "assignment-2" / "serapis"}) {}

std::string GradingQueue::grade(const GradingTask &task, const fs::path &handIn,
                                const fs::path &scratch) const {
    for (int left = kTries - 1;; --left) {
        try {
            return gradeToJson(m_norigrade, handIn, task.question, task.processes, scratch);
        } catch (const InfraError &) {
            if (left == 0 || interrupted)
                throw;
        }
    }
}

std::string GradingQueue::resultOf(const GradingTask &task, const fs::path &scratch,
                                   bool &isNew) const {
    const fs::path handIn = task.compose(scratch);
    std::string question = task.question.seed + task.question.item;
    if (task.processes > 1)
        question += fmt::format(" on {}", task.processes);
    const std::string key = m_cache.key(handIn, question);
    const std::optional<std::string> known = m_cache.find(key);
    isNew = !known;
    if (known)
        return *known;
    std::string json = grade(task, handIn, scratch);
    m_cache.store(key, json);
    return json;
}

std::size_t GradingQueue::run(const std::vector<GradingTask> &tasks, const Receiver &receive) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex; // of all that follows
    Progress progress(tasks.size());
    std::string error;
    std::atomic<bool> stopped = false;
    const auto perform = [&](std::size_t at) {
        const fs::path scratch = m_work.path() / fmt::format("{}", at);
        try {
            fs::create_directories(scratch);
            bool isNew = false;
            const std::string json = resultOf(tasks[at], scratch, isNew);
            const std::lock_guard lock(mutex);
            progress.clear();
            receive(at, json);
            progress.add(isNew);
        } catch (const InfraError &what) {
            const std::lock_guard lock(mutex);
            if (!interrupted) {
                m_setAside.push_back(describe(tasks[at]));
                progress.clear();
                std::cerr << fmt::format("{}: set aside: {}\n", m_setAside.back(), what.what());
                progress.add(true);
            }
        } catch (const std::exception &what) {
            const std::lock_guard lock(mutex);
            if (!interrupted && !stopped)
                error = fmt::format("{}: {}", tasks[at].name, what.what());
            stopped = true;
        }
        std::error_code ignored;
        fs::remove_all(scratch, ignored);
    };
    std::vector<std::thread> threads;
    threads.reserve(static_cast<std::size_t>(m_atOnce));
    for (int i = 0; i < m_atOnce; ++i)
        threads.emplace_back([&] {
            for (std::size_t at = next++; at < tasks.size() && !interrupted && !stopped;
                 at = next++)
                perform(at);
        });
    for (std::thread &thread : threads)
        thread.join();
    progress.clear();
    if (!error.empty())
        throw ExamError(error);
    return progress.done();
}

std::string commitOf(const fs::path &project) {
    const WorkFolder work;
    const Outcome outcome =
        runCommand({"git", "-C", project.string(), "describe", "--always", "--dirty"}, work.path());
    return outcome.output.substr(0, outcome.output.find('\n'));
}

} // namespace exam
