// SPDX-License-Identifier: MIT
#include "recording.h"

#include <grader/checks/image_scene.h>
#include <probe/probe.h>

#include <array>

#include "work_folder.h"

namespace calibration {

namespace {

/// Numbers of a sample, five from each random word.
class SampleNumbers {
public:
    explicit SampleNumbers(statistics::Random &random) : m_random(random) {}

    std::size_t next() {
        if (m_left-- == 0) {
            m_bits = m_random.nextBits();
            m_left = 4;
        }
        const auto number = static_cast<std::size_t>(m_bits % kSamples);
        m_bits /= kSamples;
        return number;
    }

private:
    statistics::Random &m_random;
    std::uint64_t m_bits = 0;
    int m_left = 0;
};

} // namespace

Recording::Recording(const std::string &scene, std::uint64_t seed, const std::string &integrator) {
    std::vector<protocol::File> files = grader::imageTemplate(scene).fill(seed);
    const std::string written = "\"direct_ems\"";
    const std::size_t at = files[0].bytes.find(written);
    files[0].bytes.replace(at, written.size(), "\"" + integrator + "\"");
    const WorkFolder folder;
    probe::SceneStore scenes(files);
    const protocol::Request request =
        grader::imageRequest("", static_cast<int>(kSamples), statistics::mix64(seed));
    m_values = probe::answerImage(request, scenes.getPrepared(request.text));
}

void Recording::plant(const std::function<void(std::size_t, float *)> &change) {
    for (std::size_t i = 0; i < kPixels * kSamples; ++i)
        change(i / kSamples, m_values.data() + 3 * i);
}

grader::RadianceMoments Recording::draw(int count, statistics::Random &random) const {
    grader::RadianceMoments result;
    for (auto &channel : result)
        channel.reserve(kPixels);
    SampleNumbers numbers(random);
    const double n = count;
    for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
        const float *values = m_values.data() + pixel * kSamples * 3;
        // Power sums about the first recorded sample.
        std::array<std::array<double, 3>, 3> sums{};
        for (int i = 0; i < count; ++i) {
            const float *value = values + 3 * numbers.next();
            for (std::size_t c = 0; c < 3; ++c) {
                const double x{value[c] - values[c]};
                sums[c][0] += x;
                sums[c][1] += x * x;
                sums[c][2] += x * x * x;
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            const double mean = sums[c][0] / n;
            const double second = sums[c][1] - n * mean * mean;
            const double third = sums[c][2] - 3 * mean * sums[c][1] + 2 * n * mean * mean * mean;
            result[c].push_back({n, mean + double{values[c]}, std::max(0.0, second) / (n - 1),
                                 third * n / ((n - 1) * (n - 2))});
        }
    }
    return result;
}

std::vector<float> Recording::samples(const std::vector<float> &pixels, std::uint32_t count,
                                      statistics::Random &random) const {
    std::vector<float> result;
    result.reserve(pixels.size() * count * 3);
    SampleNumbers numbers(random);
    for (const float pixel : pixels) {
        const float *values = m_values.data() + static_cast<std::size_t>(pixel) * kSamples * 3;
        for (std::uint32_t i = 0; i < count; ++i) {
            const float *value = values + 3 * numbers.next();
            result.insert(result.end(), value, value + 3);
        }
    }
    return result;
}

std::vector<double> Recording::means(std::size_t channel) const {
    std::vector<double> result(kPixels);
    for (std::size_t i = 0; i < kPixels * kSamples; ++i)
        result[i / kSamples] += static_cast<double>(m_values[3 * i + channel]) / kSamples;
    return result;
}

} // namespace calibration
