// SPDX-License-Identifier: MIT
#pragma once

#include <grader/build/variant_builder.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace grader {

/// Chooses lights.
inline constexpr char kSceneUnit[] = "scene.cpp";

/// The files that a set of checks judges, and what they stand on.
struct Group {
    std::string id;
    std::vector<std::string> own;      ///< the files that are judged
    std::vector<std::string> upstream; ///< groups whose code they call
};

/// The groups that judge how Scene chooses lights.
inline constexpr std::array<const char *, 2> kChoiceGroups = {"scene", "importance"};

/// In an order in which every group comes after its upstream.
const std::vector<Group> &groupTable();

/// \throws std::invalid_argument  if there is no such group
const Group &findGroup(const std::string &id);

/// The hand-in as it is: its own files for the group and everything upstream.
VariantPlan studentPlan(const Group &group);

/// With every file that any group judges: where the hand-in's files call each other otherwise than
/// the table says.
VariantPlan wholePlan(const Group &group);

/// Whether Emitter::sample divides by the density, by unit: those of a hand-in that are known.
using SampleConventions = std::map<std::string, bool>;

/// The hand-in with ours for what is at fault upstream, and for nothing else. One plan per
/// convention of Emitter::sample where an emitter is replaced whose own is not known and, where
/// Scene is upstream, with the hand-in's Scene and with the starter's; most faithful first.
/// \param atFault  ids of groups
/// \return         nothing if nothing upstream is at fault
std::vector<VariantPlan> mendedPlans(const Group &group, const std::set<std::string> &atFault,
                                     const SampleConventions &known);

/// The group's own files over our upstream, all of it: where it is not known what is at fault, or
/// ours does not go with the rest of the hand-in. Conventions and Scene as for mendedPlans().
std::vector<VariantPlan> followThroughPlans(const Group &group,
                                            const SampleConventions &known = {});

/// Whether the plan has the hand-in's emitters, of which its Scene may ask what ours do not know.
bool keepsEmitters(const VariantPlan &plan);

} // namespace grader
