// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <mutex>

#include "grading.h"
#include "result_cache.h"
#include "work_folder.h"

namespace exam {

/// Exit code of a verb that was interrupted, and goes on where it was when it is called again.
constexpr int kInterrupted = 75;

/// Gradings in which the grader itself fails, until one is set aside.
constexpr int kTries = 3;

/// What was set aside, for people and as Markdown; empty if nothing was.
std::string describeSetAside(const std::vector<std::string> &names);

/// From now on SIGINT and SIGTERM end no process, but every queue after the gradings at hand.
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

    /// Gradings that could not be made, as they can be repeated by hand.
    const std::vector<std::string> &setAside() const { return m_setAside; }

private:
    std::string grade(const GradingTask &task, const std::filesystem::path &handIn,
                      const std::filesystem::path &scratch) const;
    std::string resultOf(const GradingTask &task, const std::filesystem::path &scratch,
                         bool &isNew) const;

    std::filesystem::path m_norigrade;
    int m_atOnce;
    ResultCache m_cache;
    WorkFolder m_work;
    std::vector<std::string> m_setAside;
};

/// What `git describe` says of the project, for records.
std::string commitOf(const std::filesystem::path &project);

} // namespace exam
