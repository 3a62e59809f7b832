// SPDX-License-Identifier: MIT
#include <nori/block.h>
#include <nori/camera.h>
#include <nori/integrator.h>
#include <nori/render.h>
#include <nori/sampler.h>
#include <nori/scene.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <cmath>
#include <mutex>
#include <thread>

NORI_NAMESPACE_BEGIN

namespace {

/// Of an image [pixels]; with the filter's border it must still be an int.
constexpr int kMaxSide = 1 << 24;

constexpr std::chrono::milliseconds kPausePoll{20};

/// Sums of one pixel and channel about a running mean. \see Pebay 2008, eq. 2.1 and 2.2
struct Accumulator {
    double mean = 0;
    double sum2 = 0;
    double sum3 = 0;

    void add(double value, double count) {
        const double delta = value - mean;
        const double step = delta / count;
        const double term = delta * step * (count - 1);
        mean += step;
        sum3 += term * step * (count - 2) - 3 * step * sum2;
        sum2 += term;
    }
};

struct PixelSums {
    double count = 0;
    std::array<Accumulator, 3> channels;

    void add(const Color3f &value) {
        ++count;
        for (int c = 0; c < 3; ++c)
            channels[static_cast<size_t>(c)].add(static_cast<double>(value[c]), count);
    }

    PixelMoments summary() const {
        PixelMoments moments;
        moments.count = count;
        for (size_t c = 0; c < 3; ++c) {
            moments.mean[c] = channels[c].mean;
            if (count > 1)
                moments.variance[c] = channels[c].sum2 / (count - 1);
            if (count > 2)
                moments.thirdCentral[c] = count * channels[c].sum3 / ((count - 1) * (count - 2));
        }
        return moments;
    }
};

class Renderer {
public:
    Renderer(Scene &scene, const RenderOptions &options)
        : m_scene(scene),
          m_options(options),
          m_camera(*scene.getCamera()),
          m_size(m_camera.getOutputSize()) {
        if (m_size.minCoeff() <= 0 || m_size.maxCoeff() > kMaxSide)
            throw NoriException("The camera's image has %d x %d pixels; a side can have 1 to %d",
                                m_size.x(), m_size.y(), kMaxSide);
        m_sampler = makeSampler();
        m_samplesPerPixel = options.samplesPerPixel > 0
                                ? options.samplesPerPixel
                                : static_cast<int>(m_sampler->getSampleCount());
        if (m_samplesPerPixel <= 0)
            throw NoriException("The sampler takes %d samples per pixel; it needs at least one",
                                m_samplesPerPixel);
        // before hours of rendering, not after
        try {
            m_image = std::make_unique<ImageBlock>(m_size, m_camera.getReconstructionFilter());
            if (options.moments)
                m_moments.resize(static_cast<size_t>(m_size.x()) * static_cast<size_t>(m_size.y()));
        } catch (const std::bad_alloc &) {
            throw NoriException("There is not enough memory for an image of %d x %d pixels",
                                m_size.x(), m_size.y());
        }
        m_columns = (m_size.x() + NORI_BLOCK_SIZE - 1) / NORI_BLOCK_SIZE;
        m_blocks.resize(static_cast<size_t>(m_columns) *
                        static_cast<size_t>((m_size.y() + NORI_BLOCK_SIZE - 1) / NORI_BLOCK_SIZE));
    }

    RenderResult run() {
        if (m_options.preprocess)
            m_scene.getIntegrator()->preprocess(&m_scene);
        const size_t threads = m_options.threads > 0 ? static_cast<size_t>(m_options.threads)
                                                     : static_cast<size_t>(getCoreCount());
        {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            tbb::parallel_for(size_t(0), m_blocks.size(), [this](size_t i) { renderBlock(i); });
        }

        for (const auto &block : m_blocks) {
            if (block != nullptr)
                m_image->put(*block);
        }
        RenderResult result;
        result.complete = m_done == m_blocks.size();
        const std::unique_ptr<Bitmap> bitmap(m_image->toBitmap());
        result.image = *bitmap;
        result.moments = std::move(m_moments);
        result.samplesPerPixel = m_samplesPerPixel;
        result.droppedSamples = m_image->getInvalidSampleCount();
        return result;
    }

private:
    std::unique_ptr<Sampler> makeSampler() const {
        if (!m_options.seed)
            return m_scene.getSampler()->clone();
        PropertyList properties;
        properties.setInteger("sampleCount",
                              static_cast<int>(m_scene.getSampler()->getSampleCount()));
        properties.setInteger("seed", *m_options.seed);
        return std::unique_ptr<Sampler>(
            static_cast<Sampler *>(NoriObjectFactory::createInstance("independent", properties)));
    }

    static bool isSet(const std::atomic<bool> *flag) { return flag != nullptr && *flag; }

    /// Waits while rendering is paused.
    bool isCancelled() const {
        while (isSet(m_options.paused) && !isSet(m_options.cancelled))
            std::this_thread::sleep_for(kPausePoll);
        return isSet(m_options.cancelled);
    }

    void report(const std::function<void(const ImageBlock &)> &callback, const ImageBlock &block) {
        if (!callback)
            return;
        const std::lock_guard<std::mutex> lock(m_mutex);
        callback(block);
    }

    void renderBlock(size_t index) {
        if (isCancelled())
            return;
        const Point2i offset(static_cast<int>(index) % m_columns * NORI_BLOCK_SIZE,
                             static_cast<int>(index) / m_columns * NORI_BLOCK_SIZE);
        const Vector2i size = (m_size - offset).cwiseMin(NORI_BLOCK_SIZE);
        auto block = std::make_unique<ImageBlock>(size, m_camera.getReconstructionFilter());
        block->setOffset(offset);
        block->clear();
        report(m_options.blockBegun, *block);
        const std::unique_ptr<Sampler> sampler = m_sampler->clone();
        sampler->prepare(*block);
        bool complete = true;
        for (int y = 0; y < size.y(); ++y) {
            for (int x = 0; x < size.x(); ++x)
                complete = complete &&
                           renderPixel(Point2i(x + offset.x(), y + offset.y()), *sampler, *block);
        }
        if (complete)
            report(m_options.blockDone, *block);
        m_blocks[index] = std::move(block);
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_done += complete ? 1 : 0;
        if (m_options.progress)
            m_options.progress(static_cast<double>(m_done) / static_cast<double>(m_blocks.size()));
    }

    /// \return  false if cancelled; the samples until then count
    bool renderPixel(const Point2i &pixel, Sampler &sampler, ImageBlock &block) {
        PixelSums sums;
        bool complete = true;
        for (int i = 0; i < m_samplesPerPixel; ++i) {
            if (isCancelled()) {
                complete = false;
                break;
            }
            const Point2f position = pixel.cast<float>() + sampler.next2D();
            const Point2f aperture = sampler.next2D();
            Ray3f ray;
            Color3f value = m_camera.sampleRay(ray, position, aperture);
            value *= m_scene.getIntegrator()->Li(&m_scene, &sampler, ray);
            block.put(position, value);
            if (m_options.moments && value.isValid())
                sums.add(value);
        }
        if (m_options.moments)
            m_moments[static_cast<size_t>(pixel.y()) * static_cast<size_t>(m_size.x()) +
                      static_cast<size_t>(pixel.x())] = sums.summary();
        return complete;
    }

    Scene &m_scene;
    const RenderOptions &m_options;
    const Camera &m_camera;
    Vector2i m_size;
    std::unique_ptr<Sampler> m_sampler;
    int m_samplesPerPixel = 0;
    int m_columns = 0;
    std::vector<std::unique_ptr<ImageBlock>> m_blocks; ///< null: not begun
    std::unique_ptr<ImageBlock> m_image;
    std::vector<PixelMoments> m_moments;
    std::mutex m_mutex; ///< of m_done and the callbacks
    size_t m_done = 0;  ///< finished blocks
};

} // namespace

RenderResult render(Scene &scene, const RenderOptions &options) {
    return Renderer(scene, options).run();
}

NORI_NAMESPACE_END
