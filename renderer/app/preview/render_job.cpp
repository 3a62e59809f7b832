// SPDX-License-Identifier: MIT
#include <nori/block.h>
#include <nori/camera.h>
#include <nori/sampler.h>
#include <nori/scene.h>

#include <numeric>

#include <preview/render_job.h>

namespace preview {

using Lock = std::lock_guard<std::mutex>;
using Clock = std::chrono::steady_clock;

namespace {

/// Of the first pass; the others follow.
constexpr int kPassSeed = 0x70617373;
constexpr std::chrono::milliseconds kInterruptPoll{200};

std::array<int, 4> placeOf(const nori::ImageBlock &block) {
    return {block.getOffset().x(), block.getOffset().y(), block.getSize().x(), block.getSize().y()};
}

} // namespace

RenderJob::RenderJob(nori::Scene &scene, nori::RenderOptions options, std::vector<int> passes,
                     std::atomic<bool> &cancelled, Finished finished)
    : m_scene(scene),
      m_options(std::move(options)),
      m_passes(std::move(passes)),
      m_cancelled(cancelled),
      m_finished(std::move(finished)) {
    m_options.cancelled = &m_cancelled;
    m_options.paused = &m_paused;
    m_progress.samplesPerPixel = m_options.samplesPerPixel > 0
                                     ? m_options.samplesPerPixel
                                     : static_cast<int>(scene.getSampler()->getSampleCount());
}

RenderJob::~RenderJob() {
    if (m_thread.joinable()) {
        stop();
        {
            const Lock lock(m_mutex);
            m_isReleased = true;
        }
        m_released.notify_all();
        m_thread.join();
    }
}

void RenderJob::run() {
    const int all = std::accumulate(m_passes.begin(), m_passes.end(), m_progress.samplesPerPixel);
    const auto progress = m_options.progress;
    int before = 0;
    int samples = 0;
    m_options.progress = [&, this](double fraction) {
        const double overall = (before + fraction * samples) / all;
        {
            const Lock lock(m_mutex);
            m_progress.fraction = overall;
            if (m_progress.phase == Phase::Blocks)
                m_progress.blocks = fraction;
        }
        if (progress)
            progress(overall);
    };
    {
        const Lock lock(m_mutex);
        m_start = Clock::now();
        m_pauseStart = m_start;
    }
    setPhase(m_passes.empty() ? Phase::Blocks : Phase::Passes);
    bool preprocess = true; // once: it may not be asked twice
    for (size_t i = 0; i < m_passes.size() && !m_cancelled; ++i) {
        samples = m_passes[i];
        const nori::RenderResult pass = renderPass(i, preprocess);
        preprocess = false;
        if (pass.complete)
            takePass(pass.image, samples);
        before += samples;
    }
    setPhase(Phase::Blocks);
    samples = m_progress.samplesPerPixel;
    nori::RenderOptions options = m_options;
    options.preprocess = preprocess;
    watchBlocks(options, true);
    nori::RenderResult result = nori::render(m_scene, options);
    const double duration = seconds();
    {
        const Lock lock(m_mutex);
        if (!result.complete && !m_passes.empty() && m_image.size() > 0)
            result.image = m_image;
        m_image = result.image;
        m_active.clear();
        m_progress.complete = result.complete;
        m_progress.droppedSamples = result.droppedSamples;
        m_progress.seconds = duration;
        ++m_revision;
    }
    if (m_finished)
        m_finished(result, duration);
    setPhase(Phase::Finished);
}

nori::RenderResult RenderJob::renderPass(size_t pass, bool preprocess) {
    nori::RenderOptions options = m_options;
    options.samplesPerPixel = m_passes[pass];
    options.seed = kPassSeed + static_cast<int>(pass);
    options.moments = false;
    options.preprocess = preprocess;
    watchBlocks(options, false);
    return nori::render(m_scene, options);
}

void RenderJob::takePass(const nori::Bitmap &pass, int samples) {
    const Lock lock(m_mutex);
    const int before = m_progress.passSamples;
    if (before == 0) {
        m_image = pass;
    } else {
        const auto weight = static_cast<float>(samples) / static_cast<float>(before + samples);
        for (Eigen::Index i = 0; i < pass.size(); ++i)
            m_image.data()[i] += weight * (pass.data()[i] - m_image.data()[i]);
    }
    m_progress.passSamples += samples;
    ++m_revision;
}

void RenderJob::watchBlocks(nori::RenderOptions &options, bool final) {
    options.blockBegun = [this](const nori::ImageBlock &block) {
        const Lock lock(m_mutex);
        m_active.insert(placeOf(block));
    };
    options.blockDone = [this, final](const nori::ImageBlock &block) {
        const std::unique_ptr<nori::Bitmap> bitmap(block.toBitmap());
        const Lock lock(m_mutex);
        const std::array<int, 4> place = placeOf(block);
        m_active.erase(place);
        if (!final && m_progress.passSamples > 0)
            return; // a pass counts when it is whole
        if (m_image.size() == 0)
            m_image = nori::Bitmap(m_scene.getCamera()->getOutputSize());
        m_image.block(place[1], place[0], place[3], place[2]) = *bitmap;
        ++m_revision;
    };
}

void RenderJob::start(std::function<void()> wake) {
    m_thread = std::thread([this, wake = std::move(wake)] {
        try {
            run();
        } catch (...) {
            const Lock lock(m_mutex);
            m_error = std::current_exception();
            m_active.clear();
            m_progress.phase = Phase::Finished;
        }
        wake();
        std::unique_lock<std::mutex> lock(m_mutex);
        while (!m_isReleased) {
            m_released.wait_for(lock, kInterruptPoll);
            if (isInterrupted() && !m_isReleased)
                wake();
        }
    });
}

void RenderJob::wait() {
    setPaused(false);
    {
        const Lock lock(m_mutex);
        m_isReleased = true;
    }
    m_released.notify_all();
    if (m_thread.joinable())
        m_thread.join();
    if (m_error)
        std::rethrow_exception(m_error);
}

void RenderJob::setPaused(bool paused) {
    const Lock lock(m_mutex);
    if (paused == m_paused || (paused && m_progress.phase == Phase::Finished))
        return;
    if (paused)
        m_pauseStart = Clock::now();
    else
        m_pauses += Clock::now() - m_pauseStart;
    m_paused = paused;
}

void RenderJob::stop() {
    m_stopped = true;
    m_cancelled = true;
}

void RenderJob::setPhase(Phase phase) {
    const Lock lock(m_mutex);
    m_progress.phase = phase;
}

double RenderJob::seconds() const {
    const Lock lock(m_mutex);
    const Clock::time_point now = m_paused ? m_pauseStart : Clock::now();
    return std::chrono::duration<double>(now - m_start - m_pauses).count();
}

Progress RenderJob::progress() const {
    {
        const Lock lock(m_mutex);
        if (m_progress.phase == Phase::Waiting || m_progress.phase == Phase::Finished)
            return m_progress;
    }
    const double now = seconds();
    const Lock lock(m_mutex);
    Progress progress = m_progress;
    if (progress.phase != Phase::Finished)
        progress.seconds = now;
    return progress;
}

unsigned RenderJob::revision() const {
    const Lock lock(m_mutex);
    return m_revision;
}

nori::Bitmap RenderJob::image() const {
    const Lock lock(m_mutex);
    return m_image;
}

std::vector<std::array<int, 4>> RenderJob::activeBlocks() const {
    const Lock lock(m_mutex);
    return {m_active.begin(), m_active.end()};
}

std::string RenderJob::error() const {
    const Lock lock(m_mutex);
    if (!m_error)
        return "";
    try {
        std::rethrow_exception(m_error);
    } catch (const std::exception &error) {
        return error.what();
    } catch (...) {
        return "an exception of an unknown kind";
    }
}

} // namespace preview
