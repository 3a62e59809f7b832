// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

/// Exact facts of the warps to directions; used through warpCatalog().
namespace catalog::directional {

WarpEntry sphere();
WarpEntry hemisphere();
WarpEntry cosineHemisphere();
WarpEntry beckmann();

} // namespace catalog::directional
