// SPDX-License-Identifier: MIT
#include <nori/camera.h>
#include <nori/integrator.h>
#include <nori/render.h>
#include <nori/sampler.h>
#include <nori/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>

#include "fixtures.h"

namespace nori {
namespace {

/// Sees numbers of its own: a skewed law (cubes of uniform numbers) per channel.
class NoiseIntegrator : public Integrator {
public:
    Color3f Li(const Scene *, Sampler *sampler, const Ray3f &) const override {
        const float r = sampler->next1D();
        const float g = sampler->next1D();
        const Color3f value(r * r * r, 2.0f * g, 0.25f);
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_seen.push_back(value);
        return value;
    }

    std::string toString() const override { return "Noise[]"; }

    const std::vector<Color3f> &seen() const { return m_seen; }

private:
    mutable std::mutex m_mutex;
    mutable std::vector<Color3f> m_seen;
};

/// One sample in four is negative, infinite or not a number.
class FaultyIntegrator : public Integrator {
public:
    Color3f Li(const Scene *, Sampler *sampler, const Ray3f &) const override {
        const float wrong[] = {-1.0f, NAN, INFINITY};
        const float u = sampler->next1D();
        return u < 0.25f ? Color3f(1.0f, wrong[static_cast<int>(12.0f * u)], 1.0f) : Color3f(1.0f);
    }

    std::string toString() const override { return "Faulty[]"; }
};

class ThrowingIntegrator : public Integrator {
public:
    Color3f Li(const Scene *, Sampler *, const Ray3f &) const override {
        throw NoriException("no such light");
    }

    std::string toString() const override { return "Throwing[]"; }
};

/// A camera without a pixel, as a camera of one's own could be.
class EmptyCamera : public Camera {
public:
    EmptyCamera() { m_outputSize = Vector2i(0, 4); }

    Color3f sampleRay(Ray3f &, const Point2f &, const Point2f &) const override { return {}; }

    std::string toString() const override { return "EmptyCamera[]"; }
};

/// \param integrator  owned by the scene
std::unique_ptr<Scene> makeScene(Integrator *integrator, int width, int height, int seed = 0) {
    auto scene = std::make_unique<Scene>(PropertyList());
    scene->addChild(integrator);
    PropertyList camera;
    camera.setInteger("width", width);
    camera.setInteger("height", height);
    scene->addChild(test::make<Camera>("perspective", camera).release());
    PropertyList sampler;
    sampler.setInteger("sampleCount", 5);
    sampler.setInteger("seed", seed);
    scene->addChild(test::make<Sampler>("independent", sampler).release());
    scene->activate();
    return scene;
}

RenderResult renderNoise(const RenderOptions &options, int seed = 0) {
    return render(*makeScene(new NoiseIntegrator, 70, 40, seed), options);
}

bool areSameBits(const Bitmap &a, const Bitmap &b) {
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           memcmp(a.data(), b.data(), static_cast<size_t>(a.size()) * sizeof(Color3f)) == 0;
}

TEST(Render, GivesTheSameBitsWithAnyNumberOfThreads) {
    RenderOptions options;
    options.moments = true;
    options.threads = 1;
    const RenderResult one = renderNoise(options);
    EXPECT_TRUE(one.complete);
    for (const int threads : {2, 3, 7}) {
        options.threads = threads;
        const RenderResult more = renderNoise(options);
        EXPECT_TRUE(areSameBits(one.image, more.image)) << threads;
        ASSERT_EQ(one.moments.size(), more.moments.size());
        for (size_t i = 0; i < one.moments.size(); ++i)
            ASSERT_EQ(one.moments[i].thirdCentral, more.moments[i].thirdCentral) << i;
    }
}

TEST(Render, KeepsTheScenesSeedUnlessAnotherIsAskedFor) {
    RenderOptions options;
    const Bitmap scenes = renderNoise(options, 3).image;
    EXPECT_FALSE(areSameBits(scenes, renderNoise(options, 0).image));
    options.seed = 3;
    EXPECT_TRUE(areSameBits(scenes, renderNoise(options, 0).image));
    options.samplesPerPixel = 2;
    const RenderResult two = renderNoise(options, 0);
    EXPECT_EQ(two.samplesPerPixel, 2);
    options.seed.reset();
    EXPECT_TRUE(areSameBits(two.image, renderNoise(options, 3).image));
}

TEST(Render, GivesUnrelatedNoiseForSeedsThatDifferByABlock) {
    // Nori's own seeding: the image of seed 32 is that of seed 0, one block further
    const auto render32 = [](int seed) {
        RenderOptions options;
        options.seed = seed;
        return renderNoise(options).image;
    };
    const Bitmap zero = render32(0);
    for (const int seed : {32, -32, 64, 1}) {
        const Bitmap other = render32(seed);
        int equal = 0;
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x + 32 < 70; ++x) {
                equal += zero.coeff(y, x)[0] == other.coeff(y, x + 32)[0] ? 1 : 0;
                equal += zero.coeff(y, x + 32)[0] == other.coeff(y, x)[0] ? 1 : 0;
                equal += zero.coeff(y, x)[0] == other.coeff(y, x)[0] ? 1 : 0;
            }
        }
        EXPECT_LT(equal, 10) << seed;
    }
}

TEST(Render, FindsTheMomentsOfItsSamples) {
    auto *const noise = new NoiseIntegrator;
    const auto scene = makeScene(noise, 1, 1);
    RenderOptions options;
    options.threads = 1;
    options.moments = true;
    options.samplesPerPixel = 1000;
    const RenderResult result = render(*scene, options);
    ASSERT_EQ(result.moments.size(), 1u);
    ASSERT_EQ(noise->seen().size(), 1000u);
    const PixelMoments &moments = result.moments[0];
    EXPECT_EQ(moments.count, 1000.0);
    for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<size_t>(c);
        double sum = 0.0;
        for (const Color3f &value : noise->seen())
            sum += static_cast<double>(value[c]);
        const double mean = sum / 1000.0;
        double sum2 = 0.0;
        double sum3 = 0.0;
        for (const Color3f &value : noise->seen()) {
            const double difference = static_cast<double>(value[c]) - mean;
            sum2 += difference * difference;
            sum3 += difference * difference * difference;
        }
        EXPECT_NEAR(moments.mean[channel], mean, 1e-12);
        EXPECT_NEAR(moments.variance[channel], sum2 / 999.0, 1e-12);
        EXPECT_NEAR(moments.thirdCentral[channel], 1000.0 * sum3 / (999.0 * 998.0), 1e-12);
    }
    EXPECT_EQ(moments.variance[2], 0.0);
}

TEST(Render, LeavesMomentsOfTooFewSamplesAtZero) {
    RenderOptions options;
    options.moments = true;
    options.samplesPerPixel = 1;
    for (const PixelMoments &moments : renderNoise(options).moments) {
        ASSERT_EQ(moments.count, 1.0);
        ASSERT_EQ(moments.variance, (std::array<double, 3>{}));
        ASSERT_EQ(moments.thirdCentral, (std::array<double, 3>{}));
    }
    options.moments = false;
    EXPECT_TRUE(renderNoise(options).moments.empty());
}

TEST(Render, DropsSamplesThatAreNoRadiance) {
    const auto scene = makeScene(new FaultyIntegrator, 20, 20);
    RenderOptions options;
    options.samplesPerPixel = 64;
    options.moments = true;
    const RenderResult result = render(*scene, options);
    // 6400 expected of 25600, standard deviation 69
    EXPECT_NEAR(static_cast<double>(result.droppedSamples), 6400.0, 400.0);
    double kept = 0.0;
    for (const PixelMoments &moments : result.moments) {
        kept += moments.count;
        ASSERT_EQ(moments.mean, (std::array<double, 3>{1.0, 1.0, 1.0}));
    }
    EXPECT_EQ(kept + static_cast<double>(result.droppedSamples), 64.0 * 400.0);
    for (Eigen::Index i = 0; i < result.image.size(); ++i)
        ASSERT_NEAR(result.image.data()[i][1], 1.0f, 1e-5f) << i;
}

TEST(Render, StopsWhenCancelledAndKeepsWhatItHas) {
    std::atomic<bool> cancelled{false};
    RenderOptions options;
    options.threads = 1;
    options.cancelled = &cancelled;
    options.moments = true;
    options.progress = [&](double) {
        cancelled = true; // after the first of 3 x 2 blocks
    };
    const RenderResult result = renderNoise(options);
    EXPECT_FALSE(result.complete);
    double samples = 0.0;
    for (const PixelMoments &moments : result.moments)
        samples += moments.count;
    EXPECT_EQ(samples, 5.0 * 32.0 * 32.0);
    float brightest = 0.0f;
    for (Eigen::Index i = 0; i < result.image.size(); ++i)
        brightest = std::max(brightest, result.image.data()[i].maxCoeff());
    EXPECT_GT(brightest, 0.0f);
}

TEST(Render, RendersNothingWhenCancelledBefore) {
    const std::atomic<bool> cancelled{true};
    RenderOptions options;
    options.cancelled = &cancelled;
    options.samplesPerPixel = 1 << 24;
    const RenderResult result = renderNoise(options);
    EXPECT_FALSE(result.complete);
    EXPECT_TRUE((result.image.coeff(0, 0) == 0.0f).all());
}

TEST(Render, ReportsProgressThatGrowsToOne) {
    std::vector<double> fractions;
    RenderOptions options;
    options.threads = 3;
    options.progress = [&](double fraction) {
        fractions.push_back(fraction);
    };
    renderNoise(options);
    ASSERT_EQ(fractions.size(), 6u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1.0);
}

TEST(Render, PassesOnWhatAnIntegratorThrows) {
    const auto scene = makeScene(new ThrowingIntegrator, 70, 40);
    for (const int threads : {1, 3}) {
        RenderOptions options;
        options.threads = threads;
        EXPECT_THROW(render(*scene, options), NoriException);
    }
}

TEST(Render, RefusesAnImageWithoutPixelsOrTooManyOfThem) {
    Scene scene{PropertyList()};
    scene.addChild(new NoiseIntegrator);
    scene.addChild(new EmptyCamera);
    scene.activate();
    EXPECT_THROW(render(scene), NoriException);
    for (const int side : {2000000, std::numeric_limits<int>::max()})
        EXPECT_THROW(render(*makeScene(new NoiseIntegrator, side, side)), NoriException);
}

} // namespace
} // namespace nori
