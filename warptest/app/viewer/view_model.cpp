// SPDX-License-Identifier: MIT
#include <battery/domain_map.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <viewer/view_model.h>

namespace viewer {

Settings clamped(Settings settings, std::size_t subjects) {
    settings.warp = std::min(settings.warp, subjects - 1);
    settings.parameter = std::isfinite(settings.parameter)
                             ? std::clamp(settings.parameter, kMinParameter, kMaxParameter)
                             : kMaxParameter;
    settings.count = std::clamp(settings.count, std::size_t{1} << unsigned{kMinLogCount},
                                std::size_t{1} << unsigned{kMaxLogCount});
    return settings;
}

ViewModel::ViewModel(std::vector<Subject> subjects, Actions actions, Settings settings,
                     std::function<void()> wake)
    : m_subjects(std::move(subjects)),
      m_settings(clamped(settings, m_subjects.size())),
      m_runner(std::move(actions), std::move(wake)) {
    if (settings.parameter <= 0.0) {
        m_settings.parameter = defaultParameter(*subject().truth);
    }
}

void ViewModel::change(const Settings &settings) {
    const std::size_t before = m_settings.warp;
    m_settings = clamped(settings, m_subjects.size());
    if (m_settings.warp != before) {
        m_brush.reset();
    }
    m_cloud.reset();
    m_selection.reset();
    ++m_revision;
}

void ViewModel::chooseWarp(std::size_t warp) {
    Settings settings = m_settings;
    settings.warp = warp % m_subjects.size();
    settings.parameter = defaultParameter(*m_subjects[settings.warp].truth);
    change(settings);
}

const Cloud &ViewModel::cloud() {
    if (!m_cloud) {
        m_cloud = makeCloud(subject(), m_settings);
    }
    return *m_cloud;
}

void ViewModel::setBrush(const std::optional<Brush> &brush) {
    m_brush = brush;
    m_selection.reset();
    ++m_revision;
}

const std::vector<bool> &ViewModel::selection() {
    if (m_selection) {
        return *m_selection;
    }
    m_selection.emplace();
    if (!m_brush) {
        return *m_selection;
    }
    const Cloud &points = cloud();
    const battery::DomainMap domain = battery::makeDomainMap(*subject().truth);
    const auto isBetween = [](double x, double a, double b) {
        return x >= std::min(a, b) && x <= std::max(a, b);
    };
    for (std::size_t i = 0; i < points.inputs.size(); ++i) {
        std::array<double, 2> at{static_cast<double>(points.inputs[i].u),
                                 static_cast<double>(points.inputs[i].v)};
        if (m_brush->view == Brush::View::Domain) {
            at = i < points.outputs.size() ? domain.place(battery::toPoint(points.outputs[i]))
                                           : std::array{-1.0, -1.0};
        }
        m_selection->push_back(isBetween(at[0], m_brush->from[0], m_brush->to[0]) &&
                               isBetween(at[1], m_brush->from[1], m_brush->to[1]));
    }
    return *m_selection;
}

Job ViewModel::job(std::size_t warp, Job::Kind kind) const {
    Job job;
    job.kind = kind;
    job.subject = m_subjects[warp];
    job.settings = m_settings;
    job.settings.warp = warp;
    if (warp != m_settings.warp) {
        job.settings.parameter = defaultParameter(*m_subjects[warp].truth);
    }
    return job;
}

void ViewModel::runAll() {
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < m_subjects.size(); ++i) {
        jobs.push_back(job(i, Job::Kind::Test));
    }
    m_runner.start(std::move(jobs));
}

bool ViewModel::isStale(const TestReport &report) const {
    return report.settings.seed != m_settings.seed ||
           (subject().truth->hasParameter && report.settings.parameter != m_settings.parameter);
}

std::string ViewModel::statusLine() {
    const Cloud &points = cloud();
    std::string text =
        fmt::format("{} points in {:.1f} ms", points.inputs.size(), points.milliseconds);
    if (points.outside > 0) {
        text += fmt::format(" · {} out of the domain", points.outside);
    }
    if (m_brush) {
        const std::vector<bool> &chosen = selection();
        const auto count = std::count(chosen.begin(), chosen.end(), true);
        text += fmt::format(" · {} brushed ({:.2f} %)", count,
                            100.0 * static_cast<double>(count) /
                                static_cast<double>(std::max<std::size_t>(chosen.size(), 1)));
    }
    const std::string status = m_runner.status();
    return status.empty() ? text : text + " · " + status;
}

} // namespace viewer
