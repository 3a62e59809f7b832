// SPDX-License-Identifier: MIT
#include "groups.h"

#include <fmt/format.h>

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

/// Makes ours of emitters what the hand-in's are, where that is known.
/// \param divides  whether Emitter::sample divides by the density where it is not known
void keepConventions(VariantPlan &plan, const SampleConventions &known, bool divides) {
    for (const char *unit : kEmitterUnits) {
        const auto origin = plan.origins.find(unit);
        const auto seen = known.find(unit);
        if (origin == plan.origins.end() || origin->second != Origin::Reference ||
            (seen != known.end() ? seen->second : divides))
            continue;
        origin->second = Origin::ReferenceValue;
        plan.name += fmt::format(", samples of {} not divided by the density", unit);
    }
}

/// A plan per convention that is not known, with the hand-in's Scene and with the starter's.
std::vector<VariantPlan> everyWay(const VariantPlan &plan, const SampleConventions &known) {
    std::vector<VariantPlan> plans;
    const auto chosenBy = plan.origins.find(kSceneUnit);
    const bool isJudged =
        std::count(plan.judged.begin(), plan.judged.end(), std::string(kSceneUnit)) != 0;
    for (const Origin scene : {Origin::Student, Origin::Starter}) {
        const bool hasScene = chosenBy != plan.origins.end() && !isJudged;
        if (hasScene ? scene == Origin::Student && chosenBy->second == Origin::Starter
                     : scene == Origin::Starter)
            continue;
        for (const bool divides : {true, false}) {
            VariantPlan way = plan;
            keepConventions(way, known, divides);
            if (hasScene)
                way.origins[kSceneUnit] = scene;
            if (scene == Origin::Starter)
                way.name += ", the base's Scene";
            if (plans.empty() || plans.back().origins != way.origins)
                plans.push_back(std::move(way));
        }
    }
    return plans;
}

/// Ours for everything upstream, and for files that are shared with it.
VariantPlan oursAndShared(const Group &group) {
    VariantPlan plan =
        planOf("our upstream and integrator", group, Origin::Reference, Origin::Student);
    for (const std::string &id : group.upstream) {
        for (const std::string &unit : findGroup(id).own) {
            if (plan.origins.count(unit) != 0 && unit != kSceneUnit)
                plan.origins[unit] = Origin::Reference;
        }
    }
    return plan;
}

bool sharesFiles(const Group &group, const std::string &upstream) {
    const std::vector<std::string> &own = findGroup(upstream).own;
    return std::any_of(own.begin(), own.end(), [&](const std::string &unit) {
        return std::count(group.own.begin(), group.own.end(), unit) != 0;
    });
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

VariantPlan wholePlan(const Group &group) {
    VariantPlan plan = studentPlan(group);
    plan.name = "student, all files";
    for (const Group &each : groupTable()) {
        for (const std::string &unit : each.own)
            plan.origins[unit] = Origin::Student;
    }
    return plan;
}

std::vector<VariantPlan> mendedPlans(const Group &group, const std::set<std::string> &atFault,
                                     const SampleConventions &known) {
    VariantPlan plan = studentPlan(group);
    std::vector<std::string> replaced;
    bool sharesFault = false;
    for (const std::string &id : group.upstream) {
        if (atFault.count(id) == 0)
            continue;
        sharesFault = sharesFault || sharesFiles(group, id);
        for (const std::string &unit : findGroup(id).own) {
            if (std::count(group.own.begin(), group.own.end(), unit) != 0)
                continue;
            plan.origins[unit] = unit == kSceneUnit ? Origin::Starter : Origin::Reference;
            replaced.push_back(unit);
        }
    }
    std::vector<VariantPlan> plans;
    plan.name = fmt::format("ours: {}", fmt::join(replaced, ", "));
    if (!replaced.empty())
        plans = everyWay(plan, known);
    // Our integrator goes with emitters of ours only.
    if (sharesFault)
        plans.push_back(oursAndShared(group));
    return plans;
}

std::vector<VariantPlan> followThroughPlans(const Group &group, const SampleConventions &known) {
    if (upstreamUnits(group).empty())
        return {};
    std::vector<VariantPlan> plans =
        everyWay(planOf("our upstream", group, Origin::Reference, Origin::Student), known);
    if (std::any_of(group.upstream.begin(), group.upstream.end(),
                    [&](const std::string &id) { return sharesFiles(group, id); }))
        plans.push_back(oursAndShared(group));
    return plans;
}

bool keepsEmitters(const VariantPlan &plan) {
    return std::all_of(kEmitterUnits.begin(), kEmitterUnits.end(), [&](const char *unit) {
        const auto origin = plan.origins.find(unit);
        return origin == plan.origins.end() || origin->second == Origin::Student;
    });
}

} // namespace grader
