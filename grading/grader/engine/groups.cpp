// SPDX-License-Identifier: MIT
#include "groups.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace grader {

namespace {

/// Of Assignment 1: not judged, but used where it was handed in.
const std::vector<std::string> kGivenUnits = {"pointlight.cpp", "direct_whitted.cpp"};

/// Where Emitter::sample may divide by the density or not.
constexpr std::array<const char *, 2> kEmitterUnits = {"area.cpp", "environment.cpp"};

std::set<std::string> upstreamUnits(const Group &group) {
    std::set<std::string> units;
    for (const std::string &id : group.upstream) {
        const std::vector<std::string> &own = findGroup(id).own;
        units.insert(own.begin(), own.end());
    }
    for (const std::string &unit : group.own)
        units.erase(unit);
    return units;
}

VariantPlan planOf(const std::string &name, const Group &group, Origin upstream, Origin scene) {
    VariantPlan plan{name, {}, group.own};
    for (const std::string &unit : upstreamUnits(group))
        plan.origins[unit] = unit == kSceneUnit ? scene : upstream;
    for (const std::string &unit : group.own)
        plan.origins[unit] = Origin::Student;
    return plan;
}

/// Our upstream, with the hand-in's conventions where they are known.
/// \param divides  whether Emitter::sample divides by the density where it is not known
VariantPlan ourUpstream(const Group &group, Origin scene, const SampleConventions &known,
                        bool divides) {
    VariantPlan plan = planOf("our upstream", group, Origin::Reference, scene);
    for (const char *unit : kEmitterUnits) {
        const auto origin = plan.origins.find(unit);
        if (origin == plan.origins.end() || origin->second == Origin::Student)
            continue;
        const auto seen = known.find(unit);
        if (seen != known.end() ? seen->second : divides)
            continue;
        origin->second = Origin::ReferenceValue;
        plan.name += fmt::format(", samples of {} not divided by the density", unit);
    }
    if (scene == Origin::Starter)
        plan.name += ", the base's Scene";
    return plan;
}

} // namespace

const std::vector<Group> &groupTable() {
    static const std::vector<Group> groups = {
        {"warp", {"warp.cpp"}, {}},
        {"mesh", {"mesh.cpp"}, {"warp"}},
        {"area", {"area.cpp"}, {"warp", "mesh"}},
        {"environment", {"environment.cpp"}, {"warp"}},
        {"scene", {kSceneUnit}, {"warp", "mesh", "area", "environment"}},
        {"direct_ems", {"direct_ems.cpp"}, {"warp", "mesh", "area", "environment", "scene"}},
        {"importance",
         {kSceneUnit, "direct_ems.cpp"},
         {"warp", "mesh", "area", "environment", "direct_ems"}},
    };
    return groups;
}

const Group &findGroup(const std::string &id) {
    const std::vector<Group> &groups = groupTable();
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [&](const Group &group) { return group.id == id; });
    if (found == groups.end())
        throw std::invalid_argument("findGroup: no group is called \"" + id + "\"");
    return *found;
}

VariantPlan studentPlan(const Group &group) {
    VariantPlan plan = planOf("student", group, Origin::Student, Origin::Student);
    for (const std::string &unit : kGivenUnits)
        plan.origins[unit] = Origin::Student;
    return plan;
}

std::vector<VariantPlan> followThroughPlans(const Group &group, const SampleConventions &known) {
    const std::set<std::string> units = upstreamUnits(group);
    if (units.empty())
        return {};
    std::vector<VariantPlan> plans;
    for (const Origin scene : {Origin::Student, Origin::Starter}) {
        if (scene == Origin::Starter && units.count(kSceneUnit) == 0)
            continue;
        for (const bool divides : {true, false}) {
            VariantPlan plan = ourUpstream(group, scene, known, divides);
            if (plans.empty() || plans.back().name != plan.name)
                plans.push_back(std::move(plan));
        }
    }
    // A group may share a file with one that it stands on: then ours stands for that file, too.
    VariantPlan ours =
        planOf("our upstream and integrator", group, Origin::Reference, Origin::Student);
    bool sharesFiles = false;
    for (const std::string &id : group.upstream) {
        for (const std::string &unit : findGroup(id).own) {
            if (std::count(group.own.begin(), group.own.end(), unit) == 0)
                continue;
            ours.origins[unit] = Origin::Reference;
            sharesFiles = true;
        }
    }
    if (sharesFiles)
        plans.push_back(std::move(ours));
    return plans;
}

} // namespace grader
