// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/scenes/scene_template.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

namespace grader {
namespace {

namespace fs = std::filesystem;

const SceneTemplate &table() {
    static const SceneTemplate scene{fs::path(NORI_SOURCE_DIR) / "scenes/grading/table.xml"};
    return scene;
}

/// All numbers of the attribute `name`'s values.
std::vector<double> numbers(const std::string &xml, const std::string &name) {
    std::vector<double> found;
    const std::regex value("name=\"" + name + "\" value=\"([^\"]*)\"");
    for (std::sregex_iterator it(xml.begin(), xml.end(), value), end; it != end; ++it) {
        std::string text = (*it)[1];
        for (char &c : text)
            c = c == ',' ? ' ' : c;
        std::istringstream stream(text);
        for (double number = 0; stream >> number;)
            found.push_back(number);
    }
    return found;
}

TEST(SceneTemplate, IsAFunctionOfItsSeed) {
    const auto first = table().fill(1);
    const auto again = table().fill(1);
    const auto other = table().fill(2);
    ASSERT_EQ(first.size(), 6u) << "the scene and five meshes";
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].bytes, again[i].bytes);
        EXPECT_NE(first[i].bytes, other[i].bytes);
    }
    EXPECT_EQ(first[0].name, "scene.xml");
    EXPECT_EQ(first[0].bytes.find('{'), std::string::npos);
}

TEST(SceneTemplate, ScalesTheLightsAloneAndTurnsThemOff) {
    EXPECT_EQ(table().lightCount(), 5u);
    const std::string plain = table().fill(1)[0].bytes;
    const std::string changed =
        table().fill(1, {.radianceFactor = 4, .darkLights = {1, 4}})[0].bytes;
    const std::vector<double> before = numbers(plain, "radiance");
    const std::vector<double> after = numbers(changed, "radiance");
    ASSERT_EQ(before.size(), 15u);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const bool dark = i / 3 == 1 || i / 3 == 4;
        EXPECT_NEAR(after[i], dark ? 0 : 4 * before[i], 1e-6);
    }
    EXPECT_EQ(numbers(plain, "albedo"), numbers(changed, "albedo"));
}

TEST(SceneTemplate, MovesAndCutsWithoutChangingAnythingElse) {
    const auto plain = table().fill(1);
    const auto moved = table().fill(1, {.pose = 1});
    EXPECT_NE(plain[1].bytes, moved[1].bytes);
    EXPECT_NE(numbers(plain[0].bytes, "position"), numbers(moved[0].bytes, "position"));
    EXPECT_EQ(numbers(plain[0].bytes, "radiance"), numbers(moved[0].bytes, "radiance"));
    const auto cut = table().fill(1, {.cuts = 2}, "b");
    EXPECT_EQ(plain[0].bytes, cut[0].bytes);
    EXPECT_GT(cut[1].bytes.size(), plain[1].bytes.size());
    EXPECT_EQ(cut[1].name, "b/mesh0.obj");
}

TEST(SceneTemplate, AllOfThemCanBeFilled) {
    int count = 0;
    for (const auto &entry : fs::directory_iterator(fs::path(NORI_SOURCE_DIR) / "scenes/grading")) {
        if (entry.path().extension() != ".xml")
            continue;
        ++count;
        const std::string xml = SceneTemplate(entry.path()).fill(3)[0].bytes;
        EXPECT_EQ(numbers(xml, "width"), std::vector<double>{32}) << entry.path();
        EXPECT_EQ(numbers(xml, "height"), std::vector<double>{32}) << entry.path();
    }
    EXPECT_GE(count, 3);
}

TEST(SceneTemplate, SaysWhereAPlaceholderIsWrong) {
    const auto messageOf = [](const std::string &text) -> std::string {
        try {
            SceneTemplate("odd.xml", text).fill(1);
        } catch (const GraderError &error) {
            return error.what();
        }
        return "filled";
    };
    EXPECT_EQ(messageOf("<scene>\n{colour 0 1}"),
              "odd.xml:2: there is no placeholder {colour 0 1}");
    EXPECT_EQ(messageOf("{color 0 x}"), "odd.xml:1: there is no placeholder {color 0 x}");
    EXPECT_EQ(messageOf("{mesh sphere 0 0 0}"),
              "odd.xml:1: there is no placeholder {mesh sphere 0 0 0}");
    EXPECT_EQ(messageOf("{color 0"), "odd.xml:1: there is no placeholder {color 0}");
    EXPECT_EQ(messageOf("<scene/>"), "filled");
    EXPECT_THROW(SceneTemplate(fs::path("missing.xml")), GraderError);
}

} // namespace
} // namespace grader
