// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <mutex>

#include "grading.h"
#include "progress.h"
#include "result_cache.h"
#include "work_folder.h"

namespace exam {

/// Exit code of a verb that was interrupted, and goes on where it was when it is called again.
constexpr int kInterrupted = 75;

/// Gradings in which the grader itself fails, until one is set aside.
constexpr int kTries = 3;

/// Gradings in which the grader itself failed.
struct Failures {
    std::vector<std::string> setAside; ///< every time: what could not be graded
    std::size_t repeated = 0;          ///< at first, and not when they were tried again

    void add(const Failures &more);

    /// For people and as Markdown; empty if there were none.
    std::string describe() const;
};

/// Forgets earlier ones. From now on SIGINT and SIGTERM end no process, but every queue after the
/// gradings at hand.
void catchInterrupts();
bool isInterrupted();

/// Where a grading takes place, and what a kept result depends on.
struct GradingPlaces {
    std::filesystem::path project;
    std::filesystem::path norigrade; ///< the program to examine
    std::filesystem::path cache;     ///< of results
};

/// One grading of one hand-in.
struct GradingTask {
    std::string name; ///< for people
    /// Writes the hand-in into an empty folder. \return  what to grade
    std::function<std::filesystem::path(const std::filesystem::path &scratch)> compose;
    Question question;
    int processes = 1; ///< that the grader may use at the same time
};

/// Works off gradings on several threads, tells on a terminal how long the rest will take, and
/// keeps every result, so that a run that was interrupted goes on where it was.
class GradingQueue {
public:
    /// \param atOnce  gradings at the same time
    GradingQueue(const GradingPlaces &places, int atOnce);

    /// Is told of every result, one at a time, with the number of its task.
    using Receiver = std::function<void(std::size_t task, const std::string &json)>;

    /// \return  how many tasks were done or set aside: all, unless isInterrupted()
    /// \throws ExamError  if a hand-in cannot be composed or the grader cannot run, or `receive`
    ///                    throws
    std::size_t run(const std::vector<GradingTask> &tasks, const Receiver &receive);

    /// What was set aside is named as it can be repeated by hand.
    const Failures &failures() const { return m_failures; }

private:
    /// \param tries  how many it took; unchanged if the result is known
    std::string resultOf(const GradingTask &task, const std::filesystem::path &scratch, int &tries);
    std::string grade(const GradingTask &task, const std::filesystem::path &handIn,
                      const std::filesystem::path &scratch, int &tries);

    std::filesystem::path m_norigrade;
    int m_atOnce;
    ResultCache m_cache;
    WorkFolder m_work;
    std::mutex m_mutex; ///< of what follows, and of the receiver
    Progress m_progress{0};
    Failures m_failures;
};

/// What `git describe` says of the project, for records.
std::string commitOf(const std::filesystem::path &project);

} // namespace exam
