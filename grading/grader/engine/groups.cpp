// SPDX-License-Identifier: MIT
#include "groups.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace grader {

namespace {

/// Of Assignment 1: not judged, but used where it was handed in.
const std::vector<std::string> kGivenUnits = {"pointlight.cpp", "direct_whitted.cpp"};

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

std::vector<VariantPlan> followThroughPlans(const Group &group, std::optional<bool> divides) {
    const std::set<std::string> units = upstreamUnits(group);
    if (units.empty())
        return {};
    std::vector<VariantPlan> plans;
    // A group may share a file with one that it stands on: then ours stands for that file, too.
    VariantPlan ours =
        planOf("our upstream and integrator", group, Origin::Reference, Origin::Student);
    for (const std::string &id : group.upstream) {
        for (const std::string &unit : findGroup(id).own) {
            if (std::count(group.own.begin(), group.own.end(), unit) != 0)
                ours.origins[unit] = Origin::Reference;
        }
    }
    const bool sharesFiles =
        std::any_of(group.own.begin(), group.own.end(), [&](const std::string &unit) {
            return ours.origins.at(unit) != Origin::Student;
        });
    const bool samplesEmitters = units.count("area.cpp") != 0;
    const bool usesScene = units.count(kSceneUnit) != 0;
    for (const Origin scene : {Origin::Student, Origin::Starter}) {
        if (scene == Origin::Starter && !usesScene)
            continue;
        const std::string sceneName = scene == Origin::Starter ? ", the base's Scene" : "";
        if (!samplesEmitters || divides.value_or(true))
            plans.push_back(planOf("our upstream" + sceneName, group, Origin::Reference, scene));
        if (samplesEmitters && !divides.value_or(false))
            plans.push_back(planOf("our upstream, samples not divided by the density" + sceneName,
                                   group, Origin::ReferenceValue, scene));
    }
    if (sharesFiles)
        plans.push_back(std::move(ours));
    return plans;
}

} // namespace grader
