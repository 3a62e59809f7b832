// SPDX-License-Identifier: MIT
#include <nori/camera.h>
#include <nori/integrator.h>
#include <nori/sampler.h>
#include <nori/scene.h>

#include <gtest/gtest.h>

#include <cstring>

#include <preview/render_job.h>
#include <renderer/fixtures.h>

namespace preview {
namespace {

/// Noise whose scale grows with every call of preprocess().
class CountingIntegrator : public nori::Integrator {
public:
    void preprocess(const nori::Scene *) override { ++m_calls; }

    nori::Color3f Li(const nori::Scene *, nori::Sampler *sampler,
                     const nori::Ray3f &) const override {
        const float value = sampler->next1D();
        return nori::Color3f(value * static_cast<float>(m_calls), 1.0f, value * value);
    }

    std::string toString() const override { return "Counting[]"; }

private:
    int m_calls = 0;
};

class ThrowingIntegrator : public nori::Integrator {
public:
    nori::Color3f Li(const nori::Scene *, nori::Sampler *, const nori::Ray3f &) const override {
        throw nori::NoriException("no such light");
    }

    std::string toString() const override { return "Throwing[]"; }
};

std::unique_ptr<nori::Scene> makeScene(nori::Integrator *integrator) {
    auto scene = std::make_unique<nori::Scene>(nori::PropertyList());
    scene->addChild(integrator);
    nori::PropertyList camera;
    camera.setInteger("width", 70);
    camera.setInteger("height", 40);
    scene->addChild(nori::test::make<nori::Camera>("perspective", camera).release());
    nori::PropertyList sampler;
    sampler.setInteger("sampleCount", 64);
    sampler.setInteger("seed", 3);
    scene->addChild(nori::test::make<nori::Sampler>("independent", sampler).release());
    scene->activate();
    return scene;
}

nori::RenderOptions withThreads(int threads) {
    nori::RenderOptions options;
    options.threads = threads;
    options.moments = true;
    return options;
}

bool areSameBits(const nori::RenderResult &a, const nori::RenderResult &b) {
    if (a.image.rows() != b.image.rows() || a.image.cols() != b.image.cols() ||
        a.moments.size() != b.moments.size())
        return false;
    for (size_t i = 0; i < a.moments.size(); ++i) {
        if (a.moments[i].mean != b.moments[i].mean ||
            a.moments[i].thirdCentral != b.moments[i].thirdCentral)
            return false;
    }
    return std::memcmp(a.image.data(), b.image.data(),
                       static_cast<size_t>(a.image.size()) * sizeof(nori::Color3f)) == 0;
}

/// A job in a thread of its own, and what it leaves.
class WatchedJob {
public:
    WatchedJob(nori::Integrator *integrator, const nori::RenderOptions &options,
               std::vector<int> passes)
        : m_scene(makeScene(integrator)),
          job(*m_scene, options, std::move(passes), cancelled,
              [this](const nori::RenderResult &finished, double) { result = finished; }) {}

    void start() {
        job.start([] {});
    }

    void waitFor(Phase phase) const {
        while (job.progress().phase < phase)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

private:
    std::unique_ptr<nori::Scene> m_scene;

public:
    std::atomic<bool> cancelled{false};
    nori::RenderResult result;
    RenderJob job;
};

TEST(RenderJob, GivesTheBitsOfARenderWithoutPassesOrPauses) {
    const nori::RenderResult plain =
        nori::render(*makeScene(new CountingIntegrator), withThreads(1));
    for (const int threads : {1, 2, 5}) {
        for (const std::vector<int> &passes :
             {std::vector<int>{}, std::vector<int>{1}, std::vector<int>{1, 1, 2, 4, 8}}) {
            WatchedJob watched(new CountingIntegrator, withThreads(threads), passes);
            watched.start();
            for (int i = 0; i < 3; ++i) {
                watched.job.setPaused(true);
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                watched.job.image(); // as the window does
                watched.job.setPaused(false);
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
            watched.job.wait();
            EXPECT_TRUE(areSameBits(watched.result, plain)) << threads << ' ' << passes.size();
            EXPECT_TRUE(watched.job.progress().complete);
        }
    }
    nori::RenderOptions other = withThreads(1);
    other.seed = 4;
    EXPECT_FALSE(areSameBits(nori::render(*makeScene(new CountingIntegrator), other), plain));
}

TEST(RenderJob, ShowsTheWholeImageAfterTheFirstPass) {
    nori::RenderOptions options = withThreads(1);
    WatchedJob watched(new CountingIntegrator, options, {1, 1, 2});
    watched.start();
    while (watched.job.progress().passSamples == 0)
        std::this_thread::yield();
    watched.job.setPaused(true);
    const nori::Bitmap image = watched.job.image();
    ASSERT_EQ(image.rows(), 40);
    for (Eigen::Index i = 0; i < image.size(); ++i)
        ASSERT_NEAR(image.data()[i][1], 1.0f, 1e-4f) << i;
    watched.job.setPaused(false);
    watched.job.wait();
    EXPECT_EQ(watched.job.progress().passSamples, 4);
    nori::RenderResult shown = watched.result;
    shown.image = watched.job.image();
    EXPECT_TRUE(areSameBits(shown, watched.result));
}

TEST(RenderJob, StandsStillWhilePausedAndDoesNotCountTheTime) {
    nori::RenderOptions options = withThreads(2);
    options.samplesPerPixel = 20000;
    WatchedJob watched(new CountingIntegrator, options, {1});
    watched.start();
    watched.waitFor(Phase::Blocks);
    watched.job.setPaused(true);
    std::this_thread::sleep_for(std::chrono::milliseconds(60)); // samples in work end
    const Progress before = watched.job.progress();
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    const Progress after = watched.job.progress();
    EXPECT_EQ(before.fraction, after.fraction);
    EXPECT_EQ(before.seconds, after.seconds);
    watched.job.stop();
    watched.job.wait();
}

TEST(RenderJob, KeepsTheWholeImageWhenStopped) {
    nori::RenderOptions options = withThreads(2);
    options.samplesPerPixel = 1 << 24;
    WatchedJob watched(new CountingIntegrator, options, {1, 1});
    watched.start();
    watched.waitFor(Phase::Blocks);
    watched.job.stop();
    EXPECT_FALSE(watched.job.isInterrupted());
    watched.job.wait();
    EXPECT_FALSE(watched.result.complete);
    for (Eigen::Index i = 0; i < watched.result.image.size(); ++i)
        ASSERT_NEAR(watched.result.image.data()[i][1], 1.0f, 1e-4f) << i;
}

TEST(RenderJob, TellsAnInterruptFromAStop) {
    nori::RenderOptions options = withThreads(1);
    options.samplesPerPixel = 1 << 24;
    WatchedJob watched(new CountingIntegrator, options, {1});
    watched.start();
    watched.waitFor(Phase::Blocks);
    watched.job.setPaused(true);
    watched.cancelled = true; // ends a pause as well
    watched.waitFor(Phase::Finished);
    EXPECT_TRUE(watched.job.isInterrupted());
    watched.job.wait();
    EXPECT_FALSE(watched.result.complete);
}

TEST(RenderJob, ReportsProgressThatGrowsToOne) {
    std::vector<double> fractions;
    nori::RenderOptions options = withThreads(3);
    options.progress = [&](double fraction) {
        fractions.push_back(fraction);
    };
    WatchedJob watched(new CountingIntegrator, options, {1, 1, 2});
    watched.job.run();
    EXPECT_EQ(fractions.size(), 24u); // 6 blocks, 4 times
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1.0);
    EXPECT_TRUE(watched.job.activeBlocks().empty());
}

TEST(RenderJob, PassesOnWhatGoesWrong) {
    WatchedJob failing(new ThrowingIntegrator, withThreads(2), {1});
    EXPECT_THROW(failing.job.run(), nori::NoriException);

    WatchedJob watched(new ThrowingIntegrator, withThreads(2), {1});
    watched.start();
    watched.waitFor(Phase::Finished);
    EXPECT_EQ(watched.job.error(), "no such light");
    EXPECT_THROW(watched.job.wait(), nori::NoriException);
}

TEST(RenderJob, IsStoppedByItsEnd) {
    nori::RenderOptions options = withThreads(2);
    options.samplesPerPixel = 1 << 24;
    WatchedJob watched(new CountingIntegrator, options, {1});
    watched.start();
    watched.job.setPaused(true);
}

} // namespace
} // namespace preview
