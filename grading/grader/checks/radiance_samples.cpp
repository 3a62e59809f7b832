// SPDX-License-Identifier: MIT
#include "radiance_samples.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

/// One sample that carries more of the whole image than this is a firefly.
constexpr double kFireflyPart = 0.01;

} // namespace

void SampleCount::add(const SampleCount &other) {
    all += other.all;
    notNumbers += other.notNumbers;
    infinite += other.infinite;
    negative += other.negative;
    largest = std::max(largest, other.largest);
    sum += other.sum;
}

std::string SampleCount::describe() const {
    std::string text;
    if (invalidPart() > 0)
        text += fmt::format(" {:.2g} % of the samples are negative, infinite or not a number "
                            "({:.0f}, {:.0f} and {:.0f} of {:.0f}).",
                            100 * invalidPart(), negative, infinite, notNumbers, all);
    if (all > 1e4 && largest > kFireflyPart * sum && sum > 0)
        text += fmt::format(" One sample of {:.0f} makes up {:.2g} % of the image: a firefly.", all,
                            100 * largest / sum);
    return text;
}

RadianceSamples::RadianceSamples(std::size_t places) {
    for (auto &channel : m_channels)
        channel.resize(places);
}

void RadianceSamples::add(const std::vector<float> &values, int repeats) {
    std::size_t at = 0;
    for (std::size_t place = 0; place < places(); ++place) {
        for (int i = 0; i < repeats; ++i, at += 3) {
            const float *value = values.data() + at;
            ++m_count.all;
            if (std::any_of(value, value + 3, [](float v) { return std::isnan(v); }))
                ++m_count.notNumbers;
            else if (std::any_of(value, value + 3, [](float v) { return std::isinf(v); }))
                ++m_count.infinite;
            else if (std::any_of(value, value + 3, [](float v) { return v < 0; }))
                ++m_count.negative;
            else {
                double brightness = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    m_channels[c][place].add(static_cast<double>(value[c]));
                    brightness += static_cast<double>(value[c]);
                }
                m_count.largest = std::max(m_count.largest, brightness);
                m_count.sum += brightness;
            }
        }
    }
}

void RadianceSamples::merge(const RadianceSamples &other) {
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < places(); ++i)
            m_channels[c][i].merge(other.m_channels[c][i]);
    }
    m_count.add(other.m_count);
}

std::vector<statistics::MomentSummary> RadianceSamples::channel(std::size_t c) const {
    std::vector<statistics::MomentSummary> result;
    for (const statistics::RunningMoments &moments : m_channels[c]) {
        result.push_back(moments.summary());
        result.back().count = std::max(result.back().count, 2.0);
    }
    return result;
}

RadianceMoments momentsOf(const RadianceSamples &samples) {
    return {samples.channel(0), samples.channel(1), samples.channel(2)};
}

RadianceMoments pick(const RadianceMoments &moments, const std::vector<std::size_t> &which) {
    RadianceMoments result;
    for (std::size_t c = 0; c < 3; ++c) {
        for (const std::size_t i : which)
            result[c].push_back(moments[c][i]);
    }
    return result;
}

} // namespace grader
