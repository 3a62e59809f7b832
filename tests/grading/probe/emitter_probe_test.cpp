// SPDX-License-Identifier: MIT
#include <support/probe_child.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using protocol::Op;
using protocol::State;

constexpr char kProbe[] = NORI_PROBE_REFERENCE;
constexpr char kFaulty[] = NORI_PROBE_FAULTY;
constexpr char kAreaLight[] =
    R"(<mesh type="obj"><string name="filename" value="ceiling.obj"/>
       <emitter type="area"><color name="radiance" value="3,2,1"/></emitter></mesh>)";
constexpr char kPointLight[] =
    R"(<emitter type="pointlight"><point name="position" value="0,0,2"/>
       <color name="radiance" value="8,4,2"/></emitter>)";
constexpr char kEnvironment[] =
    R"(<emitter type="environment"><color name="radiance" value="1,2,3"/></emitter>)";

/// One row of EmitterSample's answer.
struct Row {
    explicit Row(const std::vector<float> &v)
        : value{v[0], v[1], v[2]},
          p{v[3], v[4], v[5]},
          n{v[6], v[7], v[8]},
          uv{v[9], v[10]},
          wi{v[11], v[12], v[13]},
          dist(v[14]),
          recordPdf(v[15]),
          pdf(v[16]),
          eval{v[17], v[18], v[19]},
          emitterSet(v[20]) {}

    std::vector<float> value, p, n, uv, wi;
    float dist, recordPdf, pdf;
    std::vector<float> eval;
    float emitterSet;
};

Row sampleOnce(const char *probe, const std::string &objects, std::vector<float> refSampleAndU) {
    return Row(test::askOne(probe, test::sceneFile(objects),
                            test::sceneRequest(Op::EmitterSample, std::move(refSampleAndU)),
                            {test::ceilingObj()}));
}

TEST(EmitterProbe, GivesTheWholeRecordOfAnAreaLight) {
    const Row row = sampleOnce(kProbe, kAreaLight, {0.5F, 0.25F, 0, 0.3F, 0.7F, 0.5F});
    const float dx = row.p[0] - 0.5F;
    const float dy = row.p[1] - 0.25F;
    const float distance = std::sqrt(dx * dx + dy * dy + 4);
    const float cosine = 2 / distance;
    EXPECT_NEAR(row.dist, distance, 1e-5F);
    EXPECT_NEAR(row.wi[0], dx / distance, 1e-5F);
    EXPECT_NEAR(row.wi[1], dy / distance, 1e-5F);
    EXPECT_NEAR(row.wi[2], cosine, 1e-5F);
    EXPECT_EQ(row.n, (std::vector<float>{0, 0, -1}));
    EXPECT_NEAR(row.uv[0], (row.p[0] + 1) / 2, 1e-5F);
    // Uniform by area, area 2, seen under this distance and cosine.
    const float expected = distance * distance / (2 * cosine);
    EXPECT_NEAR(row.pdf, expected, 1e-4F * expected);
    EXPECT_NEAR(row.recordPdf, expected, 1e-4F * expected);
    for (int c = 0; c < 3; ++c) {
        const auto radiance = static_cast<float>(3 - c);
        EXPECT_EQ(row.eval[static_cast<std::size_t>(c)], radiance);
        EXPECT_NEAR(row.value[static_cast<std::size_t>(c)], radiance / expected, 1e-5F);
    }
    EXPECT_EQ(row.emitterSet, 1.0F);
}

TEST(EmitterProbe, GivesIntensityOverSquaredDistanceOfAPointLight) {
    const Row row = sampleOnce(kProbe, kPointLight, {0, 0, 0, 0.3F, 0.7F, 0.5F});
    EXPECT_EQ(row.value, (std::vector<float>{2, 1, 0.5F}));
    EXPECT_EQ(row.pdf, 1.0F);
    EXPECT_EQ(row.dist, 2.0F);
    EXPECT_EQ(row.wi, (std::vector<float>{0, 0, 1}));
}

TEST(EmitterProbe, GivesTheUniformSphereOfAnEnvironment) {
    const Row row = sampleOnce(kProbe, kEnvironment, {0, 0, 0, 0.3F, 0.7F, 0.5F});
    EXPECT_EQ(row.eval, (std::vector<float>{1, 2, 3}));
    EXPECT_NEAR(row.pdf, 1 / (4 * M_PI), 1e-6);
    EXPECT_NEAR(std::hypot(row.wi[0], row.wi[1], row.wi[2]), 1.0F, 1e-5F);
}

TEST(EmitterProbe, ShowsWhatSampleLeavesUnset) {
    const Row row = sampleOnce(kFaulty, R"(<emitter type="faulty">
        <string name="mistake" value="none"/></emitter>)",
                               {0, 0, 0, 0.3F, 0.7F, 0.5F});
    EXPECT_EQ(row.value, (std::vector<float>{1, 2, 3}));
    EXPECT_TRUE(std::isnan(row.dist));
    EXPECT_TRUE(std::isnan(row.recordPdf));
    EXPECT_EQ(row.emitterSet, 0.0F);
    EXPECT_EQ(row.wi, (std::vector<float>{0, 0, 0}));
    EXPECT_EQ(row.pdf, 1.0F);
}

TEST(EmitterProbe, EvaluatesTheFrontAndTheBackOfALight) {
    const std::vector<float> rows =
        test::askOne(kProbe, test::sceneFile(kAreaLight),
                     test::sceneRequest(Op::EmitterEval, {0, 0, 0, 0, 0, 2, 0, 0, -1, 0.5F, 0.5F, //
                                                          0, 0, 4, 0, 0, 2, 0, 0, -1, 0.5F, 0.5F}),
                     {test::ceilingObj()});
    EXPECT_EQ(std::vector<float>(rows.begin(), rows.begin() + 3), (std::vector<float>{3, 2, 1}));
    EXPECT_NEAR(rows[3], 2.0F, 1e-5F); // distance 2, cosine 1, area 2
    EXPECT_EQ(std::vector<float>(rows.begin() + 4, rows.begin() + 7),
              (std::vector<float>{0, 0, 0}));
}

TEST(EmitterProbe, NamesThePickedLightByItsPlace) {
    const std::string objects = std::string(kAreaLight) + kPointLight + kEnvironment;
    const std::vector<float> rows =
        test::askOne(kProbe, test::sceneFile(objects),
                     test::sceneRequest(Op::EmitterPick, {0.1F, 0.5F, 0.9F}), {test::ceilingObj()});
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(rows[3 * i], static_cast<float>(i));
        EXPECT_NEAR(rows[3 * i + 1], 1.0F / 3, 1e-6F);
        EXPECT_NEAR(rows[3 * i + 2], 1.0F / 3, 1e-6F);
    }
}

TEST(EmitterProbe, CountsLightsAsTheSceneDoes) {
    // Those of the scene first, then those of meshes.
    protocol::RequestGroup group;
    group.files = {test::sceneFile(std::string(kAreaLight) + kPointLight), test::ceilingObj()};
    for (const std::uint32_t index : {0U, 1U, 2U})
        group.requests.push_back(
            test::sceneRequest(Op::EmitterSample, {0, 0, 0, 0.5F, 0.5F, 0.5F}, index));
    const test::ProbeRun run = test::runProbe(kProbe, group);
    EXPECT_EQ(run.responses[0].values.at(16), 1.0F);
    EXPECT_EQ(run.responses[1].values.at(17), 3.0F);
    EXPECT_EQ(run.responses[2].state, State::Threw);
}

/// The message of the exception that an EmitterSample on a faulty emitter ends with.
std::string messageOf(const std::string &mistake) {
    protocol::RequestGroup group;
    group.files = {test::sceneFile(R"(<emitter type="faulty"><string name="mistake" value=")" +
                                   mistake + "\"/></emitter>")};
    group.requests = {test::sceneRequest(Op::EmitterSample, {0, 0, 0, 0.5F, 0.5F, 0.5F})};
    const test::ProbeRun run = test::runProbe(kFaulty, group);
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.responses[0].state, State::Threw);
    return run.responses[0].message;
}

TEST(EmitterProbe, SaysWhichFunctionThrew) {
    EXPECT_EQ(messageOf("pdf_throws"), "Emitter::pdf: not yet implemented!");
    EXPECT_EQ(messageOf("eval_throws_int"), "Emitter::eval: something that is no std::exception");
    const std::string cut = messageOf("sample_throws_long_message");
    EXPECT_EQ(cut.size(), 2000U);
    EXPECT_EQ(cut.substr(0, 20), "Emitter::sample: mmm");
}

} // namespace
