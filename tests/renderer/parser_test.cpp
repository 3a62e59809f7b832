// SPDX-License-Identifier: MIT
#include <nori/bitmap.h>

#include <gtest/gtest.h>
#include <pcg32.h>

#include "scene_file.h"

namespace nori {
namespace {

struct BrokenScene {
    const char *name;
    std::string text;
    std::vector<std::string> message; ///< parts that the error must have
};

std::ostream &operator<<(std::ostream &stream, const BrokenScene &scene) {
    return stream << scene.text;
}

std::string repeat(const std::string &text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += text;
    return result;
}

/// Mistakes in the file and its elements.
std::vector<BrokenScene> brokenSyntax() {
    const auto in = test::sceneWith;
    return {
        {"Empty", "", {"scene.xml"}},
        {"NoElement", "<!-- nothing -->", {"scene.xml", "element"}},
        {"Malformed", "<scene>\n<integrator\n</scene>", {"scene.xml:3"}},
        {"Unclosed", "<scene>\n<integrator type=\"normals\"/>\n", {"scene.xml:"}},
        {"TwoRoots", "<scene/>\n<scene/>", {"scene.xml:2", "a second element"}},
        {"NoObject", R"(<float name="a" value="1"/>)", {"scene.xml:1", "known: bsdf, camera"}},
        {"Text", in("stray text"), {R"(scene.xml:1: <scene>: holds the text ")", "stray text"}},
        {"TextInAProperty",
         in("<emitter type=\"pointlight\"><color name=\"radiance\" value=\"1 1 1\">5</color>"
            "</emitter>"),
         {R"(scene.xml:3: <color name="radiance">: holds the text "5")"}},
        {"ElementInAProperty",
         in("<emitter type=\"pointlight\"><color name=\"radiance\" value=\"1 1 1\">\n<scale/>"
            "</color></emitter>"),
         {"scene.xml:4: <scale>: stands in a <color>, which holds no elements"}},
        {"TextInATransform",
         in(R"(<mesh type="obj"><transform name="toWorld">x<scale value="1 1 1"/></transform>)"
            "</mesh>"),
         {R"(scene.xml:3: <transform name="toWorld">: holds the text "x")"}},
        {"ElementInAStep",
         in(R"(<mesh type="obj"><transform name="toWorld"><scale value="1 1 1"><scale/></scale>)"
            "</transform></mesh>"),
         {"scene.xml:3: <scale>: stands in a <scale>"}},
        {"TooDeep", repeat("<scene>\n", 200000), {"scene.xml:"}},
        {"TooDeepButClosed",
         repeat("<scene>\n", 200000) + repeat("</scene>", 200000),
         {"scene.xml:102: <scene>: lies in more than 100 elements"}},
        {"LineBehindLatin1",
         "<?xml version=\"1.0\" encoding='ISO-8859-1'?>\n<scene><!-- " + repeat("\xf1", 50) +
             " -->\n<light/>\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n</scene>",
         {"scene.xml:3: <light>"}},
        {"LineInUtf16",
         std::string("\xff\xfe<\0s\0c\0e\0n\0e\0>\0\n\0<\0a\0/\0>\0<\0/\0s\0c\0e\0n\0e\0>\0", 42),
         {"scene.xml:2: <a>"}},
        {"UnknownEncoding",
         "<?xml version=\"1.0\" encoding=\"klingon\"?>\n<scene/>",
         {R"(scene.xml: the encoding "klingon" is unknown)"}},
        {"WrongEncoding",
         "<?xml version=\"1.0\" encoding=\"US-ASCII\"?>\n<scene name=\"\xf1\"/>",
         {"scene.xml: is not written in US-ASCII, as it says"}},
        {"UnknownElement", in("<light/>"), {"scene.xml:3: <light>: unknown element; known: bsdf"}},
        {"UnknownEmitter",
         in(R"(<emitter type="aera"/>)"),
         {R"(scene.xml:3: <emitter type="aera">: unknown emitter; known: area, environment, )"
          "pointlight"}},
        {"NoType",
         in("<emitter/>"),
         {R"(scene.xml:3: <emitter>: the attribute "type" is missing)"}},
        {"OtherKind", in(R"(<emitter type="diffuse"/>)"), {"scene.xml:3", "kind", "known: area"}},
        {"UnknownProperty",
         in("<emitter type=\"pointlight\">\n<color name=\"radianse\" value=\"1 1 1\"/></emitter>"),
         {R"(scene.xml:4: <color name="radianse">: unknown property)",
          "known: position, radiance"}},
        {"PropertyOfAnotherType",
         in(R"(<emitter type="pointlight"><float name="radiance" value="1"/></emitter>)"),
         {R"(scene.xml:3: <emitter type="pointlight">)", "'radiance'", "<color>", "<float>"}},
        {"PropertyTwice",
         in("<emitter type=\"pointlight\"><color name=\"radiance\" value=\"1 1 1\"/>\n"
            R"(<color name="radiance" value="2 2 2"/></emitter>)"),
         {R"(scene.xml:4: <color name="radiance">: the property is given twice)"}},
        {"NoValue",
         in(R"(<emitter type="pointlight"><color name="radiance"/></emitter>)"),
         {R"(scene.xml:3: <color name="radiance">: the attribute "value" is missing)"}},
        {"NoName",
         in(R"(<emitter type="pointlight"><color value="1 1 1"/></emitter>)"),
         {R"(scene.xml:3: <color>: the attribute "name" is missing)"}},
        {"NoNumber",
         in(R"(<emitter type="pointlight"><color name="radiance" value="1 x 1"/></emitter>)"),
         {R"(scene.xml:3: <color name="radiance">)", R"("x")"}},
        {"TwoNumbers",
         in(R"(<emitter type="pointlight"><color name="radiance" value="1 1"/></emitter>)"),
         {R"(scene.xml:3: <color name="radiance">: )"}},
        {"NoBoolean",
         in(R"(<bsdf type="diffuse"><boolean name="a" value="maybe"/></bsdf>)"),
         {R"(scene.xml:3: <boolean name="a">)", "maybe"}},
    };
}

/// Mistakes that an object finds.
std::vector<BrokenScene> brokenObjects() {
    const auto in = test::sceneWith;
    return {
        {"UnknownStep",
         in(R"(<mesh type="obj"><transform name="toWorld"><skew )"
            R"(value="1"/></transform></mesh>)"),
         {"scene.xml:3: <skew>", "known: lookat, matrix, rotate, scale, translate"}},
        {"ShortMatrix",
         in(R"(<mesh type="obj"><transform name="toWorld"><matrix value="1 2"/></transform>)"
            "</mesh>"),
         {"scene.xml:3: <matrix>: a matrix has 16 numbers, not 2"}},
        {"LookAtNothing",
         in(R"(<mesh type="obj"><transform name="toWorld"><lookat origin="1 1 1" )"
            R"(target="1 1 1" up="0 1 0"/></transform></mesh>)"),
         {"scene.xml:3: <lookat>: origin and target are the same point"}},
        {"NoFile", in(test::meshOf("absent.obj")), {"scene.xml:3", "absent.obj: No such file"}},
        {"EmptyFileName",
         in(test::meshOf("")),
         {R"(scene.xml:3: <mesh type="obj">: )", "'filename' is empty"}},
        {"NoFileName",
         in(R"(<mesh type="obj"/>)"),
         {R"(scene.xml:3: <mesh type="obj">)", "filename"}},
        {"NoImage",
         in(R"(<emitter type="environment"><string name="filename" value="absent.exr"/>)"
            "</emitter>"),
         {R"(scene.xml:3: <emitter type="environment">)", "absent.exr", "No such file"}},
        {"BrokenImage",
         in(R"(<emitter type="environment"><string name="filename" value="scene.xml"/>)"
            "</emitter>"),
         {R"(scene.xml:3: <emitter type="environment">)", "not an image file"}},
        {"AreaLightWithoutMesh",
         in(R"(<emitter type="area"/>)"),
         {R"(scene.xml:3: <emitter type="area">: )", "stands in the <mesh>", "not in a <scene>"}},
        {"NoIntegrator",
         R"(<scene><camera type="perspective"/></scene>)",
         {"<scene>", "integrator"}},
        {"NoCamera", R"(<scene><integrator type="normals"/></scene>)", {"<scene>", "camera"}},
        {"TwoCameras",
         in(R"(<camera type="perspective"/>)"),
         {"scene.xml:3: <camera", "only be one camera"}},
        {"NoPixels",
         "<scene>\n<camera type=\"perspective\"><integer name=\"height\" value=\"0\"/></camera>"
         "</scene>",
         {R"(scene.xml:2: <camera type="perspective">)", "1280 x 0 pixels"}},
        {"NoSamples",
         in(R"(<sampler type="independent"><integer name="sampleCount" value="0"/></sampler>)"),
         {R"(scene.xml:3: <sampler type="independent">)", "'sampleCount' is 0"}},
        {"ChildOfTheWrongKind",
         in(R"(<camera type="perspective"><bsdf type="diffuse"/></camera>)"),
         {R"(scene.xml:3: <bsdf type="diffuse">)", "not supported"}},
    };
}

class BrokenSceneTest : public testing::TestWithParam<BrokenScene> {};

TEST_P(BrokenSceneTest, IsReportedWithItsPlace) {
    const test::SceneFolder folder;
    const std::string message = folder.errorOf(GetParam().text);
    ASSERT_NE(message, "");
    for (const std::string &part : GetParam().message)
        EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks " << part;
}

const auto kName = [](const auto &scene) {
    return scene.param.name;
};
INSTANTIATE_TEST_SUITE_P(Syntax, BrokenSceneTest, testing::ValuesIn(brokenSyntax()), kName);
INSTANTIATE_TEST_SUITE_P(Objects, BrokenSceneTest, testing::ValuesIn(brokenObjects()), kName);

TEST(Parser, ReadsAnEmptySceneWithNothingToSee) {
    const test::SceneFolder folder;
    const auto root = folder.load(test::sceneWith(""));
    ASSERT_EQ(root->getClassType(), NoriObject::EScene);
    const auto &scene = static_cast<const Scene &>(*root);
    EXPECT_TRUE(scene.getMeshes().empty());
    EXPECT_TRUE(scene.getLights().empty());
    EXPECT_EQ(scene.getCamera()->getOutputSize(), Vector2i(8, 720));
}

/// All that Nori 2 reads, at values that are not its defaults; for a filter at "FILTER".
constexpr char kEveryProperty[] = R"(<scene>
<integrator type="direct_ems"/>
<sampler type="independent">
    <integer name="sampleCount" value="7"/><integer name="seed" value="7"/>
</sampler>
<camera type="perspective">
    <integer name="width" value="8"/><integer name="height" value="6"/>
    <float name="fov" value="50"/>
    <float name="nearClip" value="0.1"/><float name="farClip" value="100"/>
    <transform name="toWorld">
        <translate value="1, 2, 3"/><scale value="1, 2, 3"/><rotate angle="3" axis="0, 1, 0"/>
        <matrix value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/>
        <lookat origin="0, 0, 1" target="0, 0, 0" up="0, 1, 0"/>
    </transform>
    <rfilter FILTER</rfilter>
</camera>
<emitter type="pointlight">
    <point name="position" value="1, 2, 3"/><color name="radiance" value="1, 0.5, 0"/>
</emitter>
<emitter type="environment">
    <string name="filename" value="image.exr"/><color name="radiance" value="1, 0.5, 0"/>
    <float name="rotate" value="30"/>
</emitter>
<mesh type="obj">
    <string name="filename" value="mesh.obj"/>
    <transform name="toWorld"><scale value="2, 2, 2"/></transform>
    <bsdf type="diffuse"><color name="albedo" value="1, 0.5, 0"/></bsdf>
    <emitter type="area">
        <color name="radiance" value="1, 0.5, 0"/><float name="scale" value="2"/>
        <texture type="checker" name="radiance"/>
    </emitter>
</mesh>
<mesh type="obj">
    <string name="filename" value="mesh.obj"/>
    <bsdf type="diffuse">
        <texture type="checker" name="albedo">
            <color name="color" value="1, 0.5, 0"/>
            <integer name="scalex" value="2"/><integer name="scaley" value="3"/>
        </texture>
    </bsdf>
</mesh>
<mesh type="obj">
    <string name="filename" value="mesh.obj"/>
    <bsdf type="diffuse">
        <texture type="textmap" name="albedo">
            <string name="filename" value="image.png"/><color name="color" value="1, 0.5, 0"/>
            <float name="scalex" value="2"/><float name="scaley" value="3"/>
        </texture>
    </bsdf>
</mesh>
<mesh type="obj"><string name="filename" value="mesh.obj"/><bsdf type="mirror"/></mesh>
<mesh type="obj">
    <string name="filename" value="mesh.obj"/>
    <bsdf type="dielectric">
        <float name="intIOR" value="1.3"/><float name="extIOR" value="1.1"/>
    </bsdf>
</mesh>
</scene>)";

TEST(Parser, KnowsEveryPropertyOfNori2) {
    const test::SceneFolder folder;
    folder.write("mesh.obj", "v 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 2 3\n");
    const std::string exr = folder.write("image.exr", "");
    const std::string stem = exr.substr(0, exr.rfind('.'));
    Bitmap image(Vector2i(2, 2));
    image.fill(Color3f(0.5f));
    image.saveEXR(stem);
    image.savePNG(stem);
    for (const char *filter :
         {R"(type="gaussian"><float name="radius" value="3"/><float name="stddev" value="0.7"/>)",
          R"(type="mitchell"><float name="radius" value="3"/><float name="B" value="0.2"/>)"
          R"(<float name="C" value="0.4"/>)",
          R"(type="tent">)", R"(type="box">)"}) {
        std::string text = kEveryProperty;
        text.replace(text.find("FILTER"), 6, filter);
        EXPECT_EQ(folder.errorOf(text), "");
    }
}

TEST(Parser, ReadsCommasBlanksCommentsAndForeignLineEnds) {
    const test::SceneFolder folder;
    const auto root = folder.load("\xef\xbb\xbf<?xml version=\"1.0\"?>\r\n<!-- A\xc3\xb1o -->\r\n"
                                  "<scene>\r\n<!-- - -->\r\n<integrator type=\"normals\"/>"
                                  "<camera type=\"perspective\"/>\r\n"
                                  R"(<emitter type="pointlight" name="luz" extra="1">)"
                                  "<color name=\"radiance\" value=\"1, 2 3\"/></emitter>\r\n"
                                  "</scene>\r\n");
    EXPECT_EQ(static_cast<const Scene &>(*root).getLights().size(), 1u);
}

TEST(Parser, ReadsNamesWithAccentsInTheFilesEncoding) {
    const test::SceneFolder folder;
    folder.write("ni\xc3\xb1"
                 "a.obj",
                 "v 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 2 3\n");
    for (const std::string encoding : {"", "ISO-8859-1", "windows-1252"}) {
        const std::string declaration =
            encoding.empty() ? "" : R"(<?xml version="1.0" encoding=")" + encoding + R"("?>)";
        const std::string name = encoding.empty() ? "ni\xc3\xb1"
                                                    "a.obj"
                                                  : "ni\xf1"
                                                    "a.obj";
        EXPECT_EQ(folder.errorOf(declaration + test::sceneWith(test::meshOf(name))), "");
    }
}

TEST(Parser, SurvivesDamagedFiles) {
    const test::SceneFolder folder;
    const std::string triangle =
        "v 1 0 0\nv 2 0 0\nvt 0 1\nv 1 1 0\nvn 0 0 1\nf 1/1/1 -2/1/1 3/1/1\n";
    const std::string scene = test::sceneWith(
        test::meshOf("mesh.obj") +
        R"(<emitter type="pointlight"><color name="radiance" value="1 2 3"/></emitter>)");
    pcg32 random;
    random.seed(1, 1);
    constexpr int kFiles = 200;
    int refused = 0;
    const auto refuses = [&](const std::string &sceneText, const std::string &meshText) {
        folder.write("mesh.obj", meshText);
        return folder.errorOf(sceneText).empty() ? 0 : 1;
    };
    ASSERT_EQ(refuses(scene, triangle), 0);
    for (int i = 0; i < kFiles; ++i) {
        std::string text = i % 2 == 0 ? scene : triangle;
        const auto at = random.nextUInt(static_cast<uint32_t>(text.size()));
        if (i % 4 < 2)
            text.resize(at);
        else
            text[at] = static_cast<char>(random.nextUInt(256));
        refused += i % 2 == 0 ? refuses(text, triangle) : refuses(scene, text);
    }
    EXPECT_GT(refused, kFiles / 4);
    EXPECT_LT(refused, kFiles);
}

TEST(Parser, CountsLinesWithForeignLineEnds) {
    const test::SceneFolder folder;
    EXPECT_EQ(folder.errorOf("<scene>\r\n\r\n<emitter type=\"x\"/></scene>").find("scene.xml:3: "),
              0u);
}

TEST(Parser, AppliesTransformationsInTheirOrder) {
    const test::SceneFolder folder;
    folder.write("triangle.obj", "v 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 2 3\n");
    const auto mesh = folder.load(R"(<mesh type="obj"><string name="filename" )"
                                  R"(value="triangle.obj"/><transform name="toWorld">)"
                                  R"(<translate value="1 0 0"/><scale value="2 3 4"/>)"
                                  R"(<rotate angle="90" axis="0 0 1"/></transform></mesh>)");
    const MatrixXf &positions = static_cast<const Mesh &>(*mesh).getVertexPositions();
    // (1, 0, 0) -> (2, 0, 0) -> (4, 0, 0) -> (0, 4, 0)
    EXPECT_TRUE(positions.col(0).isApprox(Vector3f(0, 4, 0), 1e-5f)) << positions;
}

TEST(Parser, SetsParentsAndGivesAMeshWithoutBsdfADiffuseOne) {
    const test::SceneFolder folder;
    folder.write("triangle.obj", "v 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 2 3\n");
    const auto root =
        folder.load(test::sceneWith(R"(<mesh type="obj"><string name="filename" )"
                                    R"(value="triangle.obj"/><emitter type="area"/></mesh>)"));
    const auto &scene = static_cast<const Scene &>(*root);
    ASSERT_EQ(scene.getMeshes().size(), 1u);
    EXPECT_TRUE(scene.getMeshes()[0]->isEmitter());
    EXPECT_NE(scene.getMeshes()[0]->getBSDF(), nullptr);
    EXPECT_EQ(scene.getLights().size(), 1u);
}

} // namespace
} // namespace nori
