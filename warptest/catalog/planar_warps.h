// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

/// Exact facts of the planar warps; used through warpCatalog().
namespace catalog::planar {

WarpEntry square();
WarpEntry tent();
WarpEntry disk();
WarpEntry triangle();

} // namespace catalog::planar
