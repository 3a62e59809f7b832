// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/image.h>
#include <statistics/image_errors.h>
#include <statistics/tile_welch.h>

#include <optional>
#include <string>
#include <vector>

namespace grader {

/// Per-pixel moments of one channel as `nori --moments` writes them.
struct ChannelMoments {
    std::vector<statistics::MomentSummary> pixels; ///< shape [height * width]
};

/// Moments of the channels R, G, B; none if the image has none.
std::optional<std::vector<ChannelMoments>> momentsOf(const protocol::Image &image);

/// Of two independent halves of one reference together.
ChannelMoments merged(const ChannelMoments &a, const ChannelMoments &b);

struct ComparisonOptions {
    double significance = 1e-4; ///< family-wise: of a false alarm anywhere in the images
    /// Samples per pixel of a reference without moments; 0: what its header says.
    double referenceCount = 0.0;
};

enum class Likeness {
    Alike,      ///< no difference found, and a larger one than the bounds say is ruled out
    Different,  ///< by more than noise makes
    CannotTell, ///< too little is known, or too noisy
};

const char *likenessName(Likeness likeness);

struct ChannelComparison {
    std::string name; ///< `R`
    statistics::ImageErrors errors;
    std::optional<statistics::TileWelchResult> tiles;
    std::optional<statistics::ScaleEstimate> scale;
    std::optional<statistics::NoiseTest> noise; ///< of unfiltered pixels on both sides
};

struct Comparison {
    Likeness likeness = Likeness::CannotTell;
    std::vector<std::string> reasons; ///< for it, a sentence each
    int width = 0;
    int height = 0;
    std::vector<ChannelComparison> channels;
    std::optional<double> flip;   ///< mean over the pixels
    std::optional<double> pValue; ///< of all channels and statistics together
    bool scaleIsUnbiased = false; ///< two independent halves of the reference were given
    bool isFiltered = false;      ///< the tiles are those of images through the default film
    double referenceCount = 0;    ///< samples per pixel that a filtered reference is said to have
    double apparentCount = 0;     ///< the same by its noise, if it has no other fault; 0: none fits
};

/// Judges `image` against a reference.
/// \param references  one, or two independent halves of one
/// \throws GraderError  if sizes differ or a side lacks the channels R, G, B, naming which
Comparison compareImages(const protocol::Image &image,
                         const std::vector<protocol::Image> &references,
                         const ComparisonOptions &options = {});

} // namespace grader
