// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/request.h>
#include <statistics/moments.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace grader {

/// What was odd about the samples.
struct SampleCount {
    double all = 0;
    double notNumbers = 0;
    double infinite = 0;
    double negative = 0;
    double largest = 0; ///< sum of the channels of the brightest valid sample
    double sum = 0;     ///< the same of all valid samples

    /// Part of the samples that the film would drop without a trace.
    double invalidPart() const { return all > 0 ? (notNumbers + infinite + negative) / all : 0; }

    void add(const SampleCount &other);

    /// What people should know of it: empty where there is nothing.
    std::string describe() const;
};

/// Samples of Li along rays or through pixels, summed up per place and channel.
class RadianceSamples {
public:
    explicit RadianceSamples(std::size_t places = 0);

    /// Adds `repeats` samples for each place, in the order of an answer to Op::Radiance or
    /// Op::Image. Samples that are not valid are counted and left out, as the film does.
    void add(const std::vector<float> &values, int repeats);
    void merge(const RadianceSamples &other);

    /// Per place; one without a valid sample is black.
    std::vector<statistics::MomentSummary> channel(std::size_t c) const;

    std::size_t places() const { return m_channels[0].size(); }

    const SampleCount &count() const { return m_count; }

private:
    std::array<std::vector<statistics::RunningMoments>, 3> m_channels;
    SampleCount m_count;
};

/// Moments per channel and place: measured, or exact.
using RadianceMoments = std::array<std::vector<statistics::MomentSummary>, 3>;

RadianceMoments momentsOf(const RadianceSamples &samples);

/// The places `which` alone, in this order.
RadianceMoments pick(const RadianceMoments &moments, const std::vector<std::size_t> &which);

} // namespace grader
