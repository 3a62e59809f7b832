// SPDX-License-Identifier: MIT
#include <grader/checks/check.h>
#include <grader/engine/groups.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace grader {
namespace {

TEST(Groups, StandAfterWhatTheyStandOn) {
    std::set<std::string> seen;
    for (const Group &group : groupTable()) {
        for (const std::string &upstream : group.upstream)
            EXPECT_EQ(seen.count(upstream), 1u) << group.id << " stands on " << upstream;
        seen.insert(group.id);
    }
}

TEST(Groups, AreThoseOfTheCheckTable) {
    for (const Check &check : checkTable())
        EXPECT_NO_THROW(findGroup(check.group)) << check.id;
    for (const Group &group : groupTable())
        EXPECT_TRUE(std::any_of(checkTable().begin(), checkTable().end(),
                                [&](const Check &check) { return check.group == group.id; }))
            << group.id << " judges nothing";
}

TEST(Groups, JudgeTheHandInAsItIsFirst) {
    for (const Group &group : groupTable()) {
        for (const auto &[unit, origin] : studentPlan(group).origins)
            EXPECT_EQ(origin, Origin::Student) << group.id << ": " << unit;
    }
}

TEST(Groups, FollowThroughNeverReplacesWhatIsJudgedAlone) {
    for (const Group &group : groupTable()) {
        for (const VariantPlan &plan : followThroughPlans(group)) {
            const auto students =
                std::count_if(group.own.begin(), group.own.end(), [&](const std::string &unit) {
                    return plan.origins.at(unit) == Origin::Student;
                });
            EXPECT_GE(students, 1) << group.id << ": " << plan.name;
        }
    }
    EXPECT_TRUE(followThroughPlans(findGroup("warp")).empty());
    EXPECT_EQ(followThroughPlans(findGroup("mesh")).size(), 1u);
    EXPECT_EQ(followThroughPlans(findGroup("direct_ems")).size(), 4u)
        << "two conventions of Emitter::sample, with the hand-in's Scene and without";
}

TEST(Groups, FollowThroughKeepsTheConventionsOfTheHandIn) {
    const Group &group = findGroup("direct_ems");
    for (const bool area : {true, false}) {
        for (const bool environment : {true, false}) {
            const std::vector<VariantPlan> plans =
                followThroughPlans(group, {{"area.cpp", area}, {"environment.cpp", environment}});
            EXPECT_EQ(plans.size(), 2u) << "with the hand-in's Scene and without";
            for (const VariantPlan &plan : plans) {
                EXPECT_EQ(plan.origins.at("area.cpp"),
                          area ? Origin::Reference : Origin::ReferenceValue)
                    << plan.name;
                EXPECT_EQ(plan.origins.at("environment.cpp"),
                          environment ? Origin::Reference : Origin::ReferenceValue)
                    << plan.name;
            }
        }
    }
    EXPECT_EQ(followThroughPlans(group, {{"area.cpp", false}}).size(), 4u);
    // What is judged is the hand-in's, and nothing upstream of it samples an emitter.
    EXPECT_EQ(followThroughPlans(findGroup("area"), {{"area.cpp", false}}).size(), 1u);
}

TEST(Groups, AreAllInAWholePlan) {
    const VariantPlan plan = wholePlan(findGroup("mesh"));
    for (const Group &group : groupTable()) {
        for (const std::string &unit : group.own)
            EXPECT_EQ(plan.origins.at(unit), Origin::Student) << unit;
    }
    EXPECT_EQ(plan.judged, findGroup("mesh").own);
    EXPECT_NE(plan.name, studentPlan(findGroup("mesh")).name);
}

TEST(Groups, MendWhatIsAtFaultAndNothingElse) {
    const Group &group = findGroup("direct_ems");
    EXPECT_TRUE(mendedPlans(group, {}, {}).empty());
    const std::vector<VariantPlan> warp = mendedPlans(group, {"warp"}, {});
    EXPECT_EQ(warp.size(), 2u) << "with the hand-in's Scene and with the base's";
    for (const VariantPlan &plan : warp) {
        EXPECT_EQ(plan.origins.at("warp.cpp"), Origin::Reference);
        for (const char *unit : {"area.cpp", "environment.cpp", "direct_ems.cpp"})
            EXPECT_EQ(plan.origins.at(unit), Origin::Student) << plan.name;
        EXPECT_TRUE(keepsEmitters(plan));
    }
    EXPECT_EQ(warp[0].origins.at("scene.cpp"), Origin::Student);
    EXPECT_EQ(warp[1].origins.at("scene.cpp"), Origin::Starter);
    EXPECT_EQ(mendedPlans(group, {"scene"}, {}).size(), 1u);

    const std::vector<VariantPlan> area = mendedPlans(group, {"area"}, {});
    EXPECT_EQ(area.size(), 4u) << "and either convention";
    EXPECT_EQ(mendedPlans(group, {"area"}, {{"area.cpp", false}}).size(), 2u);
    EXPECT_FALSE(keepsEmitters(area[0]));
    std::set<std::string> names; // what was measured is kept by name
    for (const VariantPlan &plan : area)
        EXPECT_TRUE(names.insert(plan.name).second) << plan.name;
}

TEST(Groups, MendAnIntegratorForTheChoiceOnlyWhereItIsAtFault) {
    const Group &group = findGroup("importance");
    for (const VariantPlan &plan : mendedPlans(group, {"warp", "area"}, {}))
        EXPECT_EQ(plan.origins.at("direct_ems.cpp"), Origin::Student) << plan.name;
    const std::vector<VariantPlan> plans = mendedPlans(group, {"direct_ems"}, {});
    ASSERT_EQ(plans.size(), 1u);
    EXPECT_EQ(plans[0].origins.at("direct_ems.cpp"), Origin::Reference);
    EXPECT_EQ(plans[0].origins.at("area.cpp"), Origin::Reference) << "they go together";
    EXPECT_EQ(plans[0].origins.at("scene.cpp"), Origin::Student);
}

TEST(Checks, HaveUniqueNamesAndBoundsInOrder) {
    std::set<std::string> ids;
    for (const Check &check : checkTable()) {
        EXPECT_TRUE(ids.insert(check.id).second) << check.id;
        EXPECT_LT(check.tolerance, check.gross) << check.id;
        EXPECT_FALSE(check.what.empty()) << check.id;
        EXPECT_EQ(findCheck(check.id), &check);
    }
    EXPECT_EQ(findCheck("no.such.check"), nullptr);
}

TEST(Checks, OfDirectEmsThatTakeSecondsComeAfterTheQuickOnes) {
    const auto place = [](const char *name) {
        return findCheck(std::string("direct_ems.") + name) - checkTable().data();
    };
    const std::ptrdiff_t images = std::min({place("scene"), place("environment"), place("shadow")});
    for (const char *quick : {"point_lights", "area_light", "many_lights", "visible_light",
                              "background", "light_behind", "near_shadow", "sampler", "threads"})
        EXPECT_LT(place(quick), images) << quick;
    EXPECT_LT(images, place("far_shadow"));
}

} // namespace
} // namespace grader
