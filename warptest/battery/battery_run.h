// SPDX-License-Identifier: MIT
#pragma once

#include <battery/battery.h>

#include <string>
#include <string_view>
#include <vector>

namespace battery {

/// One repeat of testWarp().
class BatteryRun {
public:
    BatteryRun(const Warp &warp, const Density &density, const catalog::WarpEntry &target,
               const TestOptions &options, int repeat);

    /// With the density itself as the target.
    BatteryRun(const Warp &warp, const TabulatedTarget &own, const TestOptions &options,
               int repeat);

    /// \return  with verdict NotRun after a cancellation
    TestResult run();

private:
    void runSteps();
    void runOwnDensity();
    void judgeRange();
    void judgeDensity();
    void judgeDensityAtSamples();
    void judgeNormalisation();
    /// \return  whether the density is known well enough to be a target
    bool judgeTable();
    void judgeStratified();
    void judgeDistribution();
    statistics::StageResult runStage(const statistics::StageRequest &request);
    void judgeConsistency();
    void summarise();

    [[nodiscard]] std::vector<Output> outputsOf(const std::vector<Input> &inputs) const;
    [[nodiscard]] std::vector<float> densitiesOf(const std::vector<Output> &points) const;
    [[nodiscard]] std::uint64_t seed(std::string_view purpose, unsigned stage = 0) const;
    void step(double fraction) const;
    void add(TestRow row);

    const Warp &m_warp;
    const Density &m_density;
    const catalog::WarpEntry &m_target;
    const TestOptions &m_options;
    const TabulatedTarget *m_own = nullptr; ///< null: the target is known
    int m_repeat;
    double m_a;
    std::vector<Output> m_outputs; ///< of the last stage
    TestResult m_result;
};

} // namespace battery
