// SPDX-License-Identifier: MIT
#include <support/probe_child.h>

#include <gtest/gtest.h>

namespace {

using protocol::Op;
using protocol::State;

constexpr char kProbe[] = NORI_PROBE_REFERENCE;
constexpr char kCeiling[] =
    R"(<mesh type="obj"><string name="filename" value="ceiling.obj"/></mesh>)";

TEST(MeshProbe, GivesPointsNormalsAndTextureCoordinatesPerSample) {
    std::vector<float> samples;
    for (int i = 0; i < 50; ++i) {
        samples.push_back((static_cast<float>(i) + 0.5F) / 50.0F);
        samples.push_back(static_cast<float>(i * 7 % 50) / 50.0F);
    }
    const std::vector<float> rows =
        test::askOne(kProbe, test::sceneFile(kCeiling), test::sceneRequest(Op::MeshSample, samples),
                     {test::ceilingObj()});
    for (std::size_t at = 0; at < rows.size(); at += protocol::kMeshSampleSize) {
        const float *row = &rows[at];
        EXPECT_LE(std::abs(row[0]), 1.0F);
        EXPECT_LE(std::abs(row[1]), 0.5F);
        EXPECT_NEAR(row[2], 2.0F, 1e-6F);
        EXPECT_EQ(row[3], 0.0F);
        EXPECT_EQ(row[4], 0.0F);
        EXPECT_EQ(row[5], -1.0F);
        // uv is an affine function of the position.
        EXPECT_NEAR(row[6], (row[0] + 1) / 2, 1e-5F);
        EXPECT_NEAR(row[7], row[1] + 0.5F, 1e-5F);
    }
}

TEST(MeshProbe, GivesTheReciprocalOfTheAreaAtEveryPoint) {
    const std::vector<float> densities = test::askOne(
        kProbe, test::sceneFile(kCeiling),
        test::sceneRequest(Op::MeshDensity, {0, 0, 2, 0.5F, 0.1F, 2}), {test::ceilingObj()});
    EXPECT_NEAR(densities[0], 0.5F, 1e-6F);
    EXPECT_NEAR(densities[1], 0.5F, 1e-6F);
}

TEST(MeshProbe, CountsMeshesInDocumentOrder) {
    const std::string small = R"(<mesh type="obj"><string name="filename" value="ceiling.obj"/>
        <transform name="toWorld"><scale value="0.5,0.5,0.5"/></transform></mesh>)";
    protocol::RequestGroup group;
    group.files = {test::sceneFile(kCeiling + small), test::ceilingObj()};
    for (const std::uint32_t index : {0U, 1U, 2U})
        group.requests.push_back(test::sceneRequest(Op::MeshDensity, {0, 0, 1}, index));
    const test::ProbeRun run = test::runProbe(kProbe, group);
    EXPECT_NEAR(run.responses[0].values.at(0), 0.5F, 1e-6F);
    EXPECT_NEAR(run.responses[1].values.at(0), 2.0F, 1e-5F);
    EXPECT_EQ(run.responses[2].state, State::Threw);
    EXPECT_NE(run.responses[2].message.find("no such mesh"), std::string::npos);
}

} // namespace
