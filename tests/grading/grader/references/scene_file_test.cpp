// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/references/scene_file.h>
#include <support/work_folder.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

constexpr char kScene[] = R"(<scene>
  <integrator type="direct_ems"/>
  <camera type="perspective"><integer name="width" value="40"/><integer name="height" value="30"/></camera>
  <mesh type="obj"><string name="filename" value="meshes/a.obj"/></mesh>
  <emitter type="pointlight"/>
</scene>)";

std::string messageOf(const std::filesystem::path &folder, const std::string &name) {
    try {
        readSceneFile(folder, name);
    } catch (const GraderError &error) {
        return error.what();
    }
    return "";
}

TEST(SceneFile, TellsWhatTheSceneSays) {
    const support::WorkFolder folder;
    folder.write("s/a.xml", kScene);
    folder.write("s/meshes/a.obj", "v 0 0 0\n");
    const SceneFile scene = readSceneFile(folder.path(), "s/a.xml");
    EXPECT_EQ(scene.name, "s/a.xml");
    EXPECT_EQ(scene.integrator, "direct_ems");
    EXPECT_EQ(scene.width, 40);
    EXPECT_EQ(scene.height, 30);
    EXPECT_TRUE(scene.hasPointLight);
    EXPECT_EQ(scene.digest.size(), 64u);
}

TEST(SceneFile, HasTheRenderersDefaultSize) {
    const support::WorkFolder folder;
    folder.write("a.xml", "<scene/>");
    const SceneFile scene = readSceneFile(folder.path(), "a.xml");
    EXPECT_EQ(scene.width, 1280);
    EXPECT_EQ(scene.height, 720);
    EXPECT_FALSE(scene.hasPointLight);
}

TEST(SceneFile, HasAnotherDigestWhenAFileThatItNamesChanges) {
    const support::WorkFolder folder;
    folder.write("a.xml", kScene);
    folder.write("meshes/a.obj", "v 0 0 0\n");
    const std::string digest = readSceneFile(folder.path(), "a.xml").digest;
    EXPECT_EQ(readSceneFile(folder.path(), "a.xml").digest, digest);
    folder.write("meshes/a.obj", "v 0 0 1\n");
    EXPECT_NE(readSceneFile(folder.path(), "a.xml").digest, digest);
    folder.write("meshes/a.obj", "v 0 0 0\n");
    folder.write("a.xml", std::string(kScene) + "\n");
    EXPECT_NE(readSceneFile(folder.path(), "a.xml").digest, digest);
}

TEST(SceneFile, SaysWhichFileIsMissingOrNoScene) {
    const support::WorkFolder folder;
    folder.write("a.xml", kScene);
    folder.write("typo.xml", "<scene>");
    folder.write("bsdf.xml", "<bsdf type=\"diffuse\"/>");
    EXPECT_NE(messageOf(folder.path(), "a.xml").find("meshes/a.obj"), std::string::npos);
    EXPECT_NE(messageOf(folder.path(), "absent.xml").find("absent.xml"), std::string::npos);
    EXPECT_NE(messageOf(folder.path(), "typo.xml").find("typo.xml: is no scene: "),
              std::string::npos);
    EXPECT_NE(messageOf(folder.path(), "bsdf.xml").find("bsdf.xml: is no scene"),
              std::string::npos);
}

TEST(SceneFiles, AreAllBelowAFolderInOrder) {
    const support::WorkFolder folder;
    EXPECT_THROW(readSceneFiles(folder.path()), GraderError);
    EXPECT_THROW(readSceneFiles(folder.path() / "absent"), GraderError);
    folder.write("z.xml", "<scene/>");
    folder.write("b/a.xml", "<scene/>");
    folder.write("b/notes.txt", "");
    const std::vector<SceneFile> scenes = readSceneFiles(folder.path());
    ASSERT_EQ(scenes.size(), 2u);
    EXPECT_EQ(scenes[0].name, "b/a.xml");
    EXPECT_EQ(scenes[1].name, "z.xml");
}

} // namespace
} // namespace grader
