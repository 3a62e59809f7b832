// SPDX-License-Identifier: MIT
#include <support/probe_child.h>

#include <gtest/gtest.h>

namespace {

using protocol::Op;
using protocol::State;

constexpr char kProbe[] = NORI_PROBE_REFERENCE;
constexpr char kAreaLight[] =
    R"(<mesh type="obj"><string name="filename" value="ceiling.obj"/>
       <emitter type="area"/></mesh>)";

std::string messageOf(const std::vector<protocol::File> &files) {
    const test::ProbeRun run =
        test::runProbe(kProbe, {files, {test::sceneRequest(Op::SceneFacts)}});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.responses[0].state, State::Threw);
    return run.responses[0].message;
}

TEST(SceneStore, TellsTheFactsOfAScene) {
    const protocol::Request facts = test::sceneRequest(Op::SceneFacts);
    EXPECT_EQ(test::askOne(kProbe, test::sceneFile(kAreaLight), facts, {test::ceilingObj()}),
              (std::vector<float>{1, 1, 0, 0, 1}));
    EXPECT_EQ(test::askOne(kProbe, test::sceneFile(R"(<emitter type="pointlight"/>
                                              <emitter type="environment"/>)"),
                           facts),
              (std::vector<float>{2, 0, 1, 1, 1}));
    EXPECT_EQ(test::askOne(kProbe, test::sceneFile(""), facts),
              (std::vector<float>{0, 0, 0, 0, 1}));
}

TEST(SceneStore, SaysWhatIsWrongWithAScene) {
    EXPECT_NE(messageOf({}).find("scene.xml"), std::string::npos);
    EXPECT_NE(messageOf({{"scene.xml", "<scene>"}}), "");
    EXPECT_NE(messageOf({{"scene.xml", ""}}), "");
    EXPECT_EQ(messageOf({{"scene.xml", "<bsdf type=\"diffuse\"/>"}}), "scene.xml holds no scene");
    EXPECT_NE(messageOf({test::sceneFile(kAreaLight)}).find("ceiling.obj"), std::string::npos);
}

TEST(SceneStore, FindsMeshesBesideTheSceneThatNamesThem) {
    protocol::RequestGroup group;
    protocol::File small = test::ceilingObj("b/ceiling.obj");
    small.bytes = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    group.files = {test::sceneFile(kAreaLight, "normals", "a/scene.xml"),
                   test::sceneFile(kAreaLight, "normals", "b/scene.xml"),
                   test::ceilingObj("a/ceiling.obj"), small};
    for (const char *scene : {"a/scene.xml", "b/scene.xml", "a/scene.xml"}) {
        protocol::Request request = test::sceneRequest(Op::MeshDensity, {0, 0, 0});
        request.text = scene;
        group.requests.push_back(request);
    }
    const test::ProbeRun run = test::runProbe(kProbe, group);
    EXPECT_NEAR(run.responses[0].values.at(0), 0.5F, 1e-6F);
    EXPECT_NEAR(run.responses[1].values.at(0), 2.0F, 1e-5F);
    EXPECT_NEAR(run.responses[2].values.at(0), 0.5F, 1e-6F);
}

TEST(SceneStore, WritesNoFileOutsideOfItsFolder) {
    for (const char *name : {"../escaped", "a/../../escaped", "/escaped", "", "a/"}) {
        const test::ProbeRun run =
            test::runProbe(kProbe, {{{name, "x"}}, {test::sceneRequest(Op::SceneFacts)}});
        EXPECT_EQ(run.exitCode, 1) << name;
        EXPECT_EQ(run.responses[0].state, State::Pending) << name;
    }
}

} // namespace
