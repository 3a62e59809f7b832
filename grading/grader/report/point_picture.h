// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <catalog/warp_entry.h>

#include <span>
#include <string>

namespace grader {

/// Points of the unit square and what became of them, as two figures of a page. Directions are
/// seen from above and aside; those that look away are drawn fainter. At most a few thousand are
/// shown, spread over all of them. \param outputs  shape as `inputs`
std::string pointPictures(const catalog::WarpEntry &truth, std::span<const battery::Input> inputs,
                          std::span<const battery::Output> outputs, const std::string &pointSet);

} // namespace grader
