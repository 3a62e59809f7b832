// SPDX-License-Identifier: MIT
#pragma once

#include <grader/build/variant_builder.h>

#include <set>
#include <string>

namespace grader {

/// The hand-in with ours for these functions of its warp.cpp, and for no other: one warp may call
/// another, as the cosine-weighted hemisphere does that lifts a disk (Malley).
/// \param plan       has the hand-in's warp.cpp
/// \param functions  `Warp::squareToUniformDisk`
VariantPlan mendedWarps(VariantPlan plan, const std::set<std::string> &functions);

} // namespace grader
