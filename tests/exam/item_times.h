// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace exam {

/// What it took until an item of one hand-in was decided.
struct ItemTime {
    std::string handIn;
    std::string item;
    bool isGross = false;    ///< a check of it found an error that costs all of its own points
    double decidedWall = 0;  ///< seconds that programs ran for it until a check confirmed that
    double decidedCpu = 0;   ///< what they computed: hardly more on a busy machine
    double samplingWall = 0; ///< same, for all of its checks, which name the mistake
    double samplingCpu = 0;
    double judgingCpu = 0; ///< of the grader itself
    std::string slowest;   ///< its check that took most
    double slowestCpu = 0;
};

/// Runs the checks of the assignment's rubric one after the other, in this process.
class ItemClock {
public:
    ItemClock();
    ItemClock(const ItemClock &) = delete;
    ItemClock(ItemClock &&) = delete;
    ItemClock &operator=(const ItemClock &) = delete;
    ItemClock &operator=(ItemClock &&) = delete;
    ~ItemClock();

    /// \param handIn  has been graded before: what is compiled or linked here would be counted
    /// \param name    for ItemTime::handIn
    /// \return        items that lost points
    /// \throws grader::GraderError  when we fail
    std::vector<ItemTime> measure(const std::filesystem::path &handIn, const std::string &name,
                                  const std::string &seed) const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace exam
