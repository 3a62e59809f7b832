// SPDX-License-Identifier: MIT
#include <grader/digest.h>
#include <grader/error.h>
#include <grader/references/references.h>
#include <support/work_folder.h>

#include <gtest/gtest.h>

#include <fstream>

namespace grader {
namespace {

SceneFile sampleScene(const std::string &name) {
    SceneFile scene;
    scene.name = name;
    scene.integrator = "direct_ems";
    scene.width = 800;
    scene.height = 600;
    scene.digest = sha256Hex(name);
    return scene;
}

/// Renders nothing but notes what it was asked for.
class StandIn {
public:
    RenderEnd operator()(const RenderJob &job) {
        if (static_cast<int>(m_jobs.size()) == m_interruptedAfter)
            return RenderEnd::Interrupted;
        m_jobs.push_back(job);
        std::ofstream(job.output) << job.seed;
        return RenderEnd::Done;
    }

    void interruptAfter(int jobs) { m_interruptedAfter = jobs; }

    const std::vector<RenderJob> &jobs() const { return m_jobs; }

private:
    std::vector<RenderJob> m_jobs;
    int m_interruptedAfter = -1;
};

std::vector<ReferenceImage> samplePlan() {
    std::vector<ReferenceImage> plan = planReference(sampleScene("s/one.xml"), 256);
    for (const ReferenceImage &image : planReference(sampleScene("s/two.xml"), 256))
        plan.push_back(image);
    return plan;
}

class References : public testing::Test {
protected:
    ReferenceRun run(const std::vector<ReferenceImage> &plan) {
        return renderReferences("scenes", m_folder.path(), plan, std::ref(m_standIn),
                                [](const ReferenceImage &, int, int) {});
    }

    StandIn m_standIn;
    support::WorkFolder m_folder;
};

TEST(ReferencePlan, HasTwoHalvesWithAllSamplesAndDifferentSeeds) {
    const std::vector<ReferenceImage> plan = planReference(sampleScene("s/one.xml"), 256);
    ASSERT_EQ(plan.size(), 2u);
    EXPECT_EQ(plan[0].file, "s/one_a.exr");
    EXPECT_EQ(plan[1].file, "s/one_b.exr");
    EXPECT_NE(plan[0].seed, plan[1].seed);
    EXPECT_NE(plan[0].seed, planReference(sampleScene("s/two.xml"), 256)[0].seed);
    for (const ReferenceImage &image : plan) {
        EXPECT_EQ(image.samplesPerPixel, 1024);
        EXPECT_EQ(image.width, 256);
        EXPECT_EQ(image.height, 192);
    }
    const auto full = planReference(sampleScene("serapis/serapis_env.xml"), 0);
    EXPECT_EQ(full[0].samplesPerPixel, 2048);
    EXPECT_EQ(full[0].width, 800);
    EXPECT_EQ(full[0].height, 600);
}

TEST_F(References, AreRenderedOnceAndAgainWhereTheirEntryDoesNotHold) {
    std::vector<ReferenceImage> plan = samplePlan();
    EXPECT_EQ(run(plan).rendered, 4);
    ASSERT_EQ(m_standIn.jobs().size(), 4u);
    EXPECT_EQ(m_standIn.jobs()[2].scene, "scenes/s/two.xml");
    EXPECT_EQ(m_standIn.jobs()[2].seed, plan[2].seed);
    EXPECT_EQ(run(plan).kept, 4);

    m_folder.write("s/one_b.exr", "altered");
    EXPECT_EQ(run(plan).rendered, 1);
    EXPECT_EQ(m_standIn.jobs().back().seed, plan[1].seed);

    plan[3].sceneDigest = sha256Hex("a changed scene");
    const ReferenceRun again = run(plan);
    EXPECT_EQ(again.rendered, 1);
    EXPECT_EQ(again.kept, 3);
    const std::vector<ReferenceImage> manifest = readManifest(m_folder.path());
    ASSERT_EQ(manifest.size(), 4u);
    for (const ReferenceImage &image : manifest)
        EXPECT_EQ(faultOf(m_folder.path(), image), "");
}

TEST_F(References, GoOnWhereTheyWereInterrupted) {
    m_standIn.interruptAfter(3);
    const ReferenceRun first = run(samplePlan());
    EXPECT_TRUE(first.interrupted);
    EXPECT_EQ(first.rendered, 3);
    m_standIn.interruptAfter(-1);
    const ReferenceRun second = run(samplePlan());
    EXPECT_FALSE(second.interrupted);
    EXPECT_EQ(second.kept, 3);
    EXPECT_EQ(second.rendered, 1);
}

TEST_F(References, KeepTheEntriesOfOtherScenes) {
    run(samplePlan());
    run(planReference(sampleScene("s/three.xml"), 256));
    EXPECT_EQ(readManifest(m_folder.path()).size(), 6u);
}

TEST_F(References, SayWhereNoFolderCanBeMade) {
    m_folder.write("s", "a file");
    EXPECT_THROW(run(samplePlan()), GraderError);
}

TEST(RenderProcess, FailsWithTheRendererAndLeavesNothing) {
    const support::WorkFolder folder;
    folder.write("typo.xml", "<scene>");
    const std::atomic<bool> interrupted{false};
    const RenderJob job{folder.path() / "typo.xml", "", 1, 1, 4, 3, folder.path() / "out.exr"};
    testing::internal::CaptureStderr();
    EXPECT_THROW(runRenderer(job, interrupted), GraderError);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("typo.xml"), std::string::npos);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(RenderProcess, WritesTheImageUnderItsNameOnly) {
    const support::WorkFolder folder;
    folder.write("a.xml", R"(<scene><integrator type="direct_ems"/><camera type="perspective"/>
        <emitter type="environment"/></scene>)");
    const std::atomic<bool> interrupted{false};
    const RenderJob job{folder.path() / "a.xml",  "direct_mis", 2, 1, 4, 3,
                        folder.path() / "out.exr"};
    testing::internal::CaptureStderr();
    EXPECT_EQ(runRenderer(job, interrupted), RenderEnd::Done);
    testing::internal::GetCapturedStderr();
    EXPECT_GT(std::filesystem::file_size(job.output), 100u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

} // namespace
} // namespace grader
