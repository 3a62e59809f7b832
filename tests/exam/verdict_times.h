// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "item_times.h"

namespace exam {

/// Of the same figure of several hand-ins.
struct Spread {
    double median = 0;
    double p95 = 0; ///< the least value that 95 % of them do not exceed
};

/// \param values  at least one
Spread spreadOf(std::vector<double> values);

/// How long one hand-in took that nobody has compiled before.
struct VerdictTime {
    std::string name;
    bool isRight = false;
    std::map<std::string, double> phases; ///< seconds, as in results.json
    std::vector<ItemTime> items;          ///< of wrong ones

    /// `correct`, `grossly wrong` or `subtly wrong`.
    const char *kind() const;
};

/// Most that it may take until it is known that an item is grossly wrong, in seconds of sampling.
constexpr double kGrossLimit = 2;

/// Grossly wrong items that took longer.
std::vector<ItemTime> lateItems(const std::vector<VerdictTime> &times);

std::string describeTimes(const std::vector<VerdictTime> &times);
std::string timesMarkdown(const std::vector<VerdictTime> &times, const std::string &commit);

/// The verb `verdict-times`.
/// \param argv  from the verb on
/// \return      the exit code: 0 all grossly wrong items are decided in time, 1 some not, 2 usage,
///              75 interrupted
/// \throws ExamError  if the grader fails
int measureVerdictTimes(int argc, char **argv);

} // namespace exam
