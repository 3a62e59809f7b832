// SPDX-License-Identifier: MIT
#pragma once

#include <battery/callables.h>
#include <catalog/chart.h>

#include <string>
#include <vector>

namespace bindings {

/// A sampler of the renderer without a closed form: for battery::testOwnDensity().
struct Sampler {
    std::string id;       ///< "environment"
    catalog::Chart chart; ///< that its density is smooth in
    battery::Warp warp;
    battery::Density density; ///< per solid angle
};

/// Directions to an environment that is sampled by its map.
/// \param map  OpenEXR file, in latitude and longitude
/// \throws nori::NoriException  if it cannot be read
Sampler environmentSampler(const std::string &map);

/// The same with a small map made for it: a sun, a black half and a gradient.
Sampler environmentSampler();

/// Directions that `diffuse` scatters light to, seen at an angle.
Sampler diffuseSampler();

} // namespace bindings
