// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <chrono>
#include <exception>
#include <utility>

#include <viewer/runner.h>

namespace viewer {

namespace {

/// Whether a report is of the job's settings, as far as they matter for a test.
bool isOf(const TestReport &report, const Job &job) {
    const Settings &wanted = job.settings;
    return report.settings.seed == wanted.seed &&
           (!job.subject.truth->hasParameter || report.settings.parameter == wanted.parameter);
}

} // namespace

Runner::Runner(Actions actions, std::function<void()> wake)
    : m_actions(std::move(actions)), m_wake(std::move(wake)) {}

Runner::~Runner() {
    cancel();
    if (m_thread.joinable()) {
        m_thread.join();
    }
}

void Runner::start(std::vector<Job> jobs) {
    if (m_busy || jobs.empty()) {
        return;
    }
    if (m_thread.joinable()) {
        m_thread.join();
    }
    m_cancelled = false;
    m_progress = 0.0;
    m_busy = true;
    m_thread = std::thread([this, work = std::move(jobs)] { this->work(work); });
}

void Runner::cancel() {
    m_cancelled = true;
}

std::string Runner::status() const {
    const std::scoped_lock lock(m_mutex);
    return m_status;
}

std::shared_ptr<const TestReport> Runner::report(std::size_t warp) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_reports.find(warp);
    return found == m_reports.end() ? nullptr : found->second;
}

void Runner::say(std::string text) {
    {
        const std::scoped_lock lock(m_mutex);
        m_status = std::move(text);
    }
    m_wake();
}

void Runner::runTest(const Job &job, const TestControl &control) {
    TestReport report;
    const auto start = std::chrono::steady_clock::now();
    try {
        report = m_actions.test(job.subject, job.settings, control);
        if (report.result.error.empty() && !m_cancelled) {
            report.maps = drawMaps(job.subject, job.settings);
        }
    } catch (const std::exception &error) {
        report.result.verdict = battery::Status::Fail;
        report.result.headline = "the test could not go on";
        report.result.error = error.what();
    }
    if (m_cancelled) {
        return;
    }
    report.settings = job.settings;
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::string text = fmt::format("{}: {} in {:.1f} s", job.subject.name,
                                         label(report.result.verdict), report.seconds);
    {
        const std::scoped_lock lock(m_mutex);
        m_reports[job.settings.warp] = std::make_shared<const TestReport>(std::move(report));
    }
    say(text);
}

void Runner::work(const std::vector<Job> &jobs) {
    const auto total = static_cast<double>(jobs.size());
    for (std::size_t i = 0; i < jobs.size() && !m_cancelled; ++i) {
        const Job &job = jobs[i];
        TestControl control;
        control.isCancelled = [this] {
            return m_cancelled.load();
        };
        control.progress = [this, i, total](double fraction) {
            m_progress = (static_cast<double>(i) + fraction) / total;
        };
        const bool saves = job.kind == Job::Kind::Save;
        say(fmt::format("{}: {} …", job.subject.name, saves ? "saving" : "testing"));
        if (!saves) {
            runTest(job, control);
            continue;
        }
        try {
            // what is saved is of these settings, so a test of others is run again
            std::shared_ptr<const TestReport> found = report(job.settings.warp);
            if (found == nullptr || !isOf(*found, job)) {
                runTest(job, control);
                found = report(job.settings.warp);
            }
            if (found == nullptr || m_cancelled) {
                continue;
            }
            say(m_actions.save(job.subject, *found));
        } catch (const std::exception &error) {
            say(fmt::format("not saved: {}", error.what()));
        }
    }
    if (m_cancelled) {
        say("cancelled");
    }
    m_progress = 1.0;
    m_busy = false;
    m_wake();
}

} // namespace viewer
