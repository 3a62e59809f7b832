// SPDX-License-Identifier: MIT
#include "grading_queue.h"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <thread>

#include "command.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

std::atomic<bool> interrupted = false; // NOLINT: a signal can reach nothing else

/// `disk/no_root --item warp.disk --seed ...`
std::string describe(const GradingTask &task) {
    return fmt::format("{}{} --seed {}{}", task.name,
                       task.question.item.empty() ? "" : " --item " + task.question.item,
                       task.question.seed,
                       task.processes > 1 ? fmt::format(" --jobs {}", task.processes) : "");
}

} // namespace

void Failures::add(const Failures &more) {
    setAside.insert(setAside.end(), more.setAside.begin(), more.setAside.end());
    repeated += more.repeated;
}

std::string Failures::describe() const {
    std::string text;
    if (repeated > 0)
        text += fmt::format("\nIn this call {} {} needed another try, because the grader itself "
                            "failed at first.\n",
                            repeated, repeated == 1 ? "grading" : "gradings");
    if (!setAside.empty())
        text += fmt::format("\nSet aside, because the grader itself failed {} times:\n\n- {}\n",
                            kTries, fmt::join(setAside, "\n- "));
    return text;
}

void catchInterrupts() {
    interrupted = false;
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
                                const fs::path &scratch, int &tries) {
    for (tries = 1;; ++tries) {
        try {
            return gradeToJson(m_norigrade, handIn, task.question, task.processes, scratch);
        } catch (const InfraError &error) {
            if (tries == kTries || interrupted)
                throw;
            const std::lock_guard lock(m_mutex);
            m_progress.clear();
            std::cerr << fmt::format("{}: tried again: {}\n", describe(task), error.what());
        }
    }
}

std::string GradingQueue::resultOf(const GradingTask &task, const fs::path &scratch, int &tries) {
    const fs::path handIn = task.compose(scratch);
    std::string question = task.question.seed + task.question.item;
    if (task.processes > 1)
        question += fmt::format(" on {}", task.processes);
    const std::string key = m_cache.key(handIn, question);
    if (const std::optional<std::string> known = m_cache.find(key))
        return *known;
    std::string json = grade(task, handIn, scratch, tries);
    m_cache.store(key, json);
    return json;
}

std::size_t GradingQueue::run(const std::vector<GradingTask> &tasks, const Receiver &receive) {
    std::atomic<std::size_t> next = 0;
    std::string error;
    m_progress = Progress(tasks.size());
    std::atomic<bool> stopped = false;
    const auto perform = [&](std::size_t at) {
        const fs::path scratch = m_work.path() / fmt::format("{}", at);
        try {
            fs::create_directories(scratch);
            int tries = 0;
            const std::string json = resultOf(tasks[at], scratch, tries);
            const std::lock_guard lock(m_mutex);
            m_progress.clear();
            receive(at, json);
            m_failures.repeated += tries > 1 ? 1 : 0;
            m_progress.add(tries > 0);
        } catch (const InfraError &what) {
            const std::lock_guard lock(m_mutex);
            if (!interrupted) {
                m_failures.setAside.push_back(describe(tasks[at]));
                m_progress.clear();
                std::cerr << fmt::format("{}: set aside: {}\n", m_failures.setAside.back(),
                                         what.what());
                m_progress.add();
            }
        } catch (const std::exception &what) {
            const std::lock_guard lock(m_mutex);
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
    m_progress.clear();
    if (!error.empty())
        throw ExamError(error);
    return m_progress.done();
}

std::string commitOf(const fs::path &project) {
    const WorkFolder work;
    const Outcome outcome =
        runCommand({"git", "-C", project.string(), "describe", "--always", "--dirty"}, work.path());
    return outcome.output.substr(0, outcome.output.find('\n'));
}

} // namespace exam
