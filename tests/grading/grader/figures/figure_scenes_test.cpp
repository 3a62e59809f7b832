// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/figures/figure_scenes.h>
#include <grader/submission/figure_name.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

TEST(FigureName, IsReadAsSceneAndSamples) {
    const auto expect = [](const char *stem, const char *scene, int samples, bool asAsked) {
        const FigureName name = parseFigureName(stem);
        EXPECT_EQ(name.scene, scene) << stem;
        EXPECT_EQ(name.samples, samples) << stem;
        EXPECT_EQ(name.asAsked, asAsked) << stem;
    };
    expect("serapis_ems_64", "serapis_ems", 64, true);
    expect("Serapis-EMS 64spp", "serapis_ems", 64, false);
    expect("serapisems64", "serapisems", 64, false);
    expect("cbox_ems_is_64", "cbox_ems_is", 64, true);
    expect("cbox_ems", "cbox_ems", 0, true);
    expect("1", "", 1, false);
    expect("", "", 0, true);
    expect("cbox_99999999999999999999", "cbox_99999999999999999999", 0, true);
    expect("cb\xC3\xB3x_4", "cb\xC3\xB3x", 4, true);
}

TEST(FigureScenes, FindNamesThatAreNearlyRight) {
    const FigureScenes scenes(std::string(NORI_SOURCE_DIR) + "/scenes/assignment-2", false);
    using Fit = FigureScenes::Fit;
    const auto expect = [&](const char *name, Fit fit, const char *scene) {
        const FigureScenes::Found found = scenes.find(name);
        EXPECT_EQ(found.fit, fit) << name;
        EXPECT_EQ(found.scene, scene) << name;
    };
    expect("cbox_ems", Fit::Exact, "cbox_ems");
    expect("cbox", Fit::Near, "cbox_ems");
    expect("buny_ems", Fit::Near, "bunny_ems");
    expect("serapisems", Fit::Near, "serapis_ems");
    expect("cbox_ems_is", Fit::Variant, "cbox_ems");
    expect("serapis", Fit::None, ""); // one of several
    expect("uniformtriangle", Fit::None, "");
    expect("", Fit::None, "");
    EXPECT_FALSE(scenes.given());
    EXPECT_TRUE(scenes.file("table_ems").has_filename());
}

TEST(FigureScenes, NeedAFolderThatHoldsOne) {
    EXPECT_THROW(FigureScenes("/no/such/folder", true), GraderError);
    EXPECT_THROW(FigureScenes(std::string(NORI_SOURCE_DIR) + "/cmake", true), GraderError);
}

} // namespace
} // namespace grader
