// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <viewer/cloud.h>
#include <viewer/runner.h>

namespace viewer {

/// A rectangle that was brushed, in one of the two flat views, both [0, 1]^2.
struct Brush {
    enum class View { Square, Domain } view = View::Square;
    std::array<double, 2> from{};
    std::array<double, 2> to{};
};

/// Everything the window shows, without any graphics.
class ViewModel {
public:
    /// \param subjects  never empty
    ViewModel(std::vector<Subject> subjects, Actions actions, Settings settings,
              std::function<void()> wake);

    [[nodiscard]] const std::vector<Subject> &subjects() const { return m_subjects; }

    [[nodiscard]] const Subject &subject() const { return m_subjects[m_settings.warp]; }

    [[nodiscard]] const Settings &settings() const { return m_settings; }

    /// Takes over the settings, in their ranges. Another warp ends the brushing.
    void change(const Settings &settings);

    /// Chooses a warp (modulo their number) with its default parameter.
    void chooseWarp(std::size_t warp);

    /// The points of the settings, drawn anew when those have changed.
    const Cloud &cloud();

    /// Changes with every new cloud or selection: what was made from an older one is stale.
    [[nodiscard]] unsigned revision() const { return m_revision; }

    void setBrush(const std::optional<Brush> &brush);

    [[nodiscard]] const std::optional<Brush> &brush() const { return m_brush; }

    /// Whether each point is in the brush; empty when there is none.
    const std::vector<bool> &selection();

    void runOne() { m_runner.start({job(m_settings.warp, Job::Kind::Test)}); }

    void runAll();

    void save() { m_runner.start({job(m_settings.warp, Job::Kind::Save)}); }

    [[nodiscard]] Runner &runner() { return m_runner; }

    [[nodiscard]] const Runner &runner() const { return m_runner; }

    /// The report of the chosen warp, or null.
    [[nodiscard]] std::shared_ptr<const TestReport> report() const {
        return m_runner.report(m_settings.warp);
    }

    /// The controls say something else now than when the report was made.
    [[nodiscard]] bool isStale(const TestReport &report) const;

    /// The line at the bottom.
    std::string statusLine();

private:
    [[nodiscard]] Job job(std::size_t warp, Job::Kind kind) const;

    std::vector<Subject> m_subjects;
    Settings m_settings;
    std::optional<Cloud> m_cloud;
    std::optional<Brush> m_brush;
    std::optional<std::vector<bool>> m_selection;
    unsigned m_revision = 0;
    Runner m_runner; ///< last: it ends before what its jobs use
};

} // namespace viewer
