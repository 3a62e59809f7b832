// SPDX-License-Identifier: MIT
#include "comparison.h"

#include <grader/error.h>
#include <grader/images/flip.h>
#include <grader/images/likeness.h>
#include <statistics/filtered_tiles.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace grader {

namespace {

using protocol::Image;
using statistics::MomentImage;
using statistics::MomentSummary;
using statistics::TileWelchResult;

constexpr const char *kNames[] = {"R", "G", "B"};

using Moments = std::optional<std::vector<ChannelMoments>>;

MomentImage viewOf(const Image &image, const ChannelMoments &moments) {
    return {image.width, image.height, moments.pixels};
}

void requireColor(const Image &image, const std::string &which) {
    for (const char *name : kNames) {
        if (image.channel(name) != nullptr)
            continue;
        std::vector<std::string> there;
        for (const protocol::Channel &channel : image.channels)
            there.push_back(channel.name);
        throw GraderError(
            fmt::format("{} has no channel {}; it has {}", which, name, fmt::join(there, ", ")));
    }
}

/// Means of the two halves, where there are two: their error is smaller than either's.
std::vector<float> averaged(const std::vector<Image> &references, const char *name) {
    std::vector<float> values = references.front().channel(name)->values;
    if (references.size() == 2) {
        const std::vector<float> &other = references[1].channel(name)->values;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = 0.5F * (values[i] + other[i]);
    }
    return values;
}

std::size_t countNonFinite(const Image &image) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.channels.front().values.size(); ++i) {
        count += std::any_of(std::begin(kNames), std::end(kNames), [&](const char *name) {
            return !std::isfinite(image.channel(name)->values[i]);
        });
    }
    return count;
}

bool hasVariance(const std::vector<ChannelMoments> &moments) {
    return std::all_of(moments.begin(), moments.end(), [](const ChannelMoments &channel) {
        return std::all_of(channel.pixels.begin(), channel.pixels.end(),
                           [](const MomentSummary &pixel) { return pixel.count >= 2; });
    });
}

/// Samples per pixel as nori's header says; 0 if it does not.
double countInHeader(const Image &image) {
    const auto found = image.attributes.find("spp");
    double count = 0;
    if (found != image.attributes.end())
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), count);
    return count;
}

statistics::NoiseTest noiseOf(const ChannelMoments &a, const ChannelMoments &b) {
    std::vector<double> differences;
    std::vector<double> variances;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        differences.push_back(a.pixels[i].mean - b.pixels[i].mean);
        variances.push_back(a.pixels[i].variance / a.pixels[i].count +
                            b.pixels[i].variance / b.pixels[i].count);
    }
    return statistics::noiseTest(differences, variances);
}

class Comparer {
public:
    Comparer(const Image &image, const std::vector<Image> &references,
             const ComparisonOptions &options)
        : m_image(image),
          m_references(references),
          m_options(options),
          m_moments(momentsOf(image)) {
        for (const Image &reference : references)
            m_referenceMoments.push_back(momentsOf(reference));
        m_result.width = image.width;
        m_result.height = image.height;
        m_result.scaleIsUnbiased = references.size() == 2;
    }

    Comparison compare() {
        if (!areFinite())
            return std::move(m_result);
        for (const char *name : kNames) {
            ChannelComparison channel;
            channel.name = name;
            channel.errors = statistics::imageErrors(m_image.channel(name)->values,
                                                     averaged(m_references, name));
            m_result.channels.push_back(std::move(channel));
        }
        addFlip();
        if (isSameImage()) {
            m_result.likeness = Likeness::Alike;
            m_result.reasons.emplace_back("Both hold the same numbers in every pixel.");
        } else if (test()) {
            judge(m_result, m_options.significance);
        }
        return std::move(m_result);
    }

private:
    bool areFinite() {
        const std::size_t own = countNonFinite(m_image);
        std::size_t others = 0;
        for (const Image &reference : m_references)
            others += countNonFinite(reference);
        if (own == 0 && others == 0)
            return true;
        const auto say = [&](std::size_t count, const char *which) {
            if (count > 0)
                m_result.reasons.push_back(fmt::format(
                    "{} has {} not finite (NaN or infinite).", which,
                    count == 1 ? "1 pixel that is" : fmt::format("{} pixels that are", count)));
        };
        say(own, "The image");
        say(others, "The reference");
        m_result.likeness = others == 0 ? Likeness::Different : Likeness::CannotTell;
        return false;
    }

    bool isSameImage() const {
        return m_references.size() == 1 &&
               std::all_of(std::begin(kNames), std::end(kNames), [&](const char *name) {
                   return m_image.channel(name)->values ==
                          m_references.front().channel(name)->values;
               });
    }

    void addFlip() {
        Image reference = m_references.front();
        for (protocol::Channel &channel : reference.channels) {
            const bool isColor =
                std::any_of(std::begin(kNames), std::end(kNames),
                            [&](const char *name) { return channel.name == name; });
            if (isColor)
                channel.values = averaged(m_references, channel.name.c_str());
        }
        double sum = 0;
        const std::vector<float> map = flip(m_image, reference);
        for (const float value : map)
            sum += double{value};
        m_result.flip = sum / static_cast<double>(map.size());
    }

    bool cannot(const std::string &reason) {
        m_result.reasons.push_back(reason);
        return false;
    }

    /// Fills in what the moments allow. \return  false if nothing can be tested
    bool test() {
        if (!m_moments)
            return cannot("The image has no moments, so nothing tells noise from error: render it "
                          "with `nori --moments`.");
        if (!hasVariance(*m_moments))
            return cannot("The image has pixels with fewer than 2 samples, which say nothing about "
                          "noise: render it with more.");
        const bool bothHave =
            std::all_of(m_referenceMoments.begin(), m_referenceMoments.end(),
                        [](const Moments &moments) { return moments && hasVariance(*moments); });
        return bothHave ? testUnfiltered() : testFiltered();
    }

    bool testUnfiltered() {
        for (std::size_t c = 0; c < std::size(kNames); ++c) {
            const ChannelMoments &own = (*m_moments)[c];
            const ChannelMoments &first = (*m_referenceMoments.front())[c];
            const ChannelMoments &last = (*m_referenceMoments.back())[c];
            const ChannelMoments all = m_references.size() == 2 ? merged(first, last) : first;
            ChannelComparison &channel = m_result.channels[c];
            channel.tiles =
                statistics::tileWelchTest(viewOf(m_image, own), viewOf(m_image, all), config());
            channel.noise = noiseOf(own, all);
            if (channel.tiles->referenceMean > 0)
                channel.scale = statistics::estimateScale(
                    viewOf(m_image, own), viewOf(m_image, first), viewOf(m_image, last), config());
        }
        return true;
    }

    bool testFiltered() {
        if (m_references.size() == 2)
            return cannot("The halves of the reference have no moments: give them as one image.");
        const double count = m_options.referenceCount > 0 ? m_options.referenceCount
                                                          : countInHeader(m_references.front());
        if (!(count > 0))
            return cannot("The reference has no moments and does not say how many samples a pixel "
                          "has: give --reference-spp.");
        m_result.isFiltered = true;
        for (std::size_t c = 0; c < std::size(kNames); ++c) {
            const statistics::FilteredPair pair{
                viewOf(m_image, (*m_moments)[c]), m_image.channel(kNames[c])->values,
                m_references.front().channel(kNames[c])->values, count};
            m_result.channels[c].tiles = statistics::filteredTileTest(pair, config());
        }
        m_result.referenceCount = count;
        addApparentCount();
        return true;
    }

    /// The number of samples with which the mean square of the scores would be 1.
    void addApparentCount() {
        double own = 0;
        for (const MomentSummary &pixel : m_moments->front().pixels)
            own += pixel.count / static_cast<double>(m_moments->front().pixels.size());
        double meanSquare = 0;
        for (const ChannelComparison &channel : m_result.channels) {
            const auto tested = static_cast<double>(channel.tiles->tilesTested);
            if (tested > 0)
                meanSquare += channel.tiles->sumOfSquares / tested /
                              static_cast<double>(m_result.channels.size());
        }
        const double variance = meanSquare * (1 / own + 1 / m_result.referenceCount) - 1 / own;
        if (variance > 0)
            m_result.apparentCount = 1 / variance;
    }

    statistics::TileWelchConfig config() const {
        statistics::TileWelchConfig config;
        config.significance = m_options.significance;
        config.leavesOutSkewedTiles = true;
        return config;
    }

    const Image &m_image;
    const std::vector<Image> &m_references;
    const ComparisonOptions &m_options;
    Moments m_moments;
    std::vector<Moments> m_referenceMoments;
    Comparison m_result;
};

} // namespace

ChannelMoments merged(const ChannelMoments &a, const ChannelMoments &b) {
    ChannelMoments all = a;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) {
        MomentSummary &to = all.pixels[i];
        const MomentSummary &from = b.pixels[i];
        const double count = to.count + from.count;
        const double part = from.count / count;
        to.mean += part * (from.mean - to.mean);
        to.variance += part * (from.variance - to.variance);
        to.thirdCentral += part * (from.thirdCentral - to.thirdCentral);
        to.count = count;
    }
    return all;
}

std::optional<std::vector<ChannelMoments>> momentsOf(const Image &image) {
    const protocol::Channel *count = image.channel("count.Y");
    if (count == nullptr)
        return std::nullopt;
    std::vector<ChannelMoments> all;
    for (const std::string name : kNames) {
        const protocol::Channel *mean = image.channel("mean." + name);
        const protocol::Channel *variance = image.channel("variance." + name);
        const protocol::Channel *third = image.channel("third." + name);
        if (mean == nullptr || variance == nullptr || third == nullptr)
            return std::nullopt;
        ChannelMoments moments;
        for (std::size_t i = 0; i < count->values.size(); ++i)
            moments.pixels.push_back(
                {count->values[i], mean->values[i], variance->values[i], third->values[i]});
        all.push_back(std::move(moments));
    }
    return all;
}

Comparison compareImages(const Image &image, const std::vector<Image> &references,
                         const ComparisonOptions &options) {
    requireColor(image, "The image");
    for (const Image &reference : references) {
        requireColor(reference, "The reference");
        if (reference.width != image.width || reference.height != image.height)
            throw GraderError(fmt::format("The image has {} x {} pixels, the reference {} x {}: "
                                          "only images of one size can be compared",
                                          image.width, image.height, reference.width,
                                          reference.height));
    }
    return Comparer(image, references, options).compare();
}

} // namespace grader
