// SPDX-License-Identifier: MIT
#pragma once

#include <nori/render.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace preview {

enum class Phase { Waiting, Passes, Blocks, Finished };

/// Where a render stands.
struct Progress {
    Phase phase = Phase::Waiting;
    double fraction = 0;       ///< of all the work, in [0, 1]
    double blocks = 0;         ///< share of the blocks that have their final values
    int passSamples = 0;       ///< samples per pixel of the passes so far
    int samplesPerPixel = 0;   ///< of the image
    double seconds = 0;        ///< since the start, without pauses
    bool complete = false;     ///< finished and not stopped before
    size_t droppedSamples = 0; ///< known at the end
};

/// A render that can be watched, paused and stopped from another thread. First come passes over the
/// whole image, with random numbers of their own, to be looked at and thrown away; then nori's
/// render(), which knows nothing of them: so the result has the same bits as without.
class RenderJob {
public:
    using Finished = std::function<void(const nori::RenderResult &result, double seconds)>;

    /// \param options    their `cancelled`, `paused` and block callbacks are the job's own
    /// \param passes     samples per pixel of each pass
    /// \param cancelled  stops the render; stop() sets it as well
    /// \param finished   called in the render's thread, to write the image
    RenderJob(nori::Scene &scene, nori::RenderOptions options, std::vector<int> passes,
              std::atomic<bool> &cancelled, Finished finished);
    /// Stops the render and waits for it.
    ~RenderJob();
    RenderJob(const RenderJob &) = delete;
    RenderJob &operator=(const RenderJob &) = delete;
    RenderJob(RenderJob &&) = delete;
    RenderJob &operator=(RenderJob &&) = delete;

    /// Renders, in this thread. \throws what rendering or `finished` throw
    void run();

    /// Renders in a thread of its own.
    /// \param wake  called there when the render has ended, and when it is cancelled after that
    void start(std::function<void()> wake);

    bool isStarted() const { return m_thread.joinable(); }

    /// Waits for a render that was started. \throws what run() would have thrown
    void wait();

    void setPaused(bool paused);

    bool isPaused() const { return m_paused; }

    /// Ends the render early; what is there counts as its result.
    void stop();

    /// Something other than stop() has cancelled it, such as Ctrl-C.
    bool isInterrupted() const { return m_cancelled && !m_stopped; }

    Progress progress() const;

    /// Changes with every change of image().
    unsigned revision() const;

    /// The best that is known of every pixel: its final value, else the mean of the passes.
    nori::Bitmap image() const;

    /// Blocks in work: upper left corner (x, y), width and height.
    std::vector<std::array<int, 4>> activeBlocks() const;

    /// What run() threw; empty if nothing.
    std::string error() const;

private:
    nori::RenderResult renderPass(size_t pass, bool preprocess);
    void takePass(const nori::Bitmap &pass, int samples);
    void watchBlocks(nori::RenderOptions &options, bool final);
    void setPhase(Phase phase);
    double seconds() const;

    nori::Scene &m_scene;
    nori::RenderOptions m_options;
    std::vector<int> m_passes;
    std::atomic<bool> &m_cancelled;
    Finished m_finished;
    std::atomic<bool> m_stopped{false};
    std::atomic<bool> m_paused{false};
    std::thread m_thread;

    mutable std::mutex m_mutex; ///< of what follows
    std::condition_variable m_released;
    bool m_isReleased = false;
    Progress m_progress;
    unsigned m_revision = 0;
    nori::Bitmap m_image;
    std::set<std::array<int, 4>> m_active;
    std::exception_ptr m_error;
    std::chrono::steady_clock::time_point m_start;
    std::chrono::steady_clock::time_point m_pauseStart;
    std::chrono::steady_clock::duration m_pauses{};
};

} // namespace preview
