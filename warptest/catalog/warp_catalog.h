// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

#include <span>
#include <string_view>

namespace catalog {

/// All warps of <nori/warp.h>, in the order of that header.
std::span<const WarpEntry> warpCatalog();

/// The warp with this id, or null.
const WarpEntry *findWarp(std::string_view id);

/// The warp with this id.
/// \throws std::invalid_argument  that names the known ids.
const WarpEntry &requireWarp(std::string_view id);

} // namespace catalog
