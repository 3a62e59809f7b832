// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "recording.h"

namespace calibration {

/// What whole judgements must come to.
enum class Asked {
    Nothing, ///< the error is one that a pass allows
    NoFail,  ///< right code
    AllFail, ///< the error lies above it
};

/// A mistake, as what it does to a sample of a pixel.
struct Planted {
    const char *name;
    std::function<void(std::size_t, float *)> change;
    Asked asked = Asked::AllFail;
    const char *integrator = "direct_ems";
};

/// The scene in which mistakes are planted.
extern const char *const kPlantedScene;

/// No mistake, then one of each kind; those with `only` in their names.
std::vector<Planted> plantedMistakes(const std::string &only);

} // namespace calibration
