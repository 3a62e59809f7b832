// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

/// Exact facts of the warps to directions; used through warpCatalog().
namespace catalog::directional {

extern const WarpEntry kSphere;
extern const WarpEntry kHemisphere;
extern const WarpEntry kCosineHemisphere;
extern const WarpEntry kBeckmann;

} // namespace catalog::directional
