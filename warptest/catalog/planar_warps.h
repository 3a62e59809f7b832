// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

/// Exact facts of the planar warps; used through warpCatalog().
namespace catalog::planar {

extern const WarpEntry kSquare;
extern const WarpEntry kTent;
extern const WarpEntry kDisk;
extern const WarpEntry kTriangle;

} // namespace catalog::planar
