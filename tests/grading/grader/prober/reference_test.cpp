// SPDX-License-Identifier: MIT
//
// The whole way, with our own complete renderer: scene, memory, box, answers.
#include <grader/prober/prober.h>
#include <grader/scenes/test_scene.h>

#include <cmath>

#include "../sandbox/hostile_box.h"

namespace grader {

namespace {

using protocol::Op;
using protocol::Request;
using protocol::State;

const Vector3d kAlbedo{0.5, 0.25, 0.75};

class ReferenceProbe : public HostileBox {
protected:
    void SetUp() override {
        HostileBox::SetUp();
        m_probe = place(PROBE_REFERENCE);
    }

    ProbeAnswer ask(const TestScene &scene, const std::vector<Request> &requests) const {
        static const Sandbox sandbox;
        BoxLimits limits;
        limits.wall = std::chrono::seconds(120); // the machine may be busy
        ProbeAnswer answer = askProbe(sandbox, m_probe, {scene.files(), requests}, limits);
        const auto *exited = std::get_if<BoxExited>(&answer.outcome.end);
        EXPECT_TRUE(exited != nullptr && exited->code == 0)
            << describe(answer.outcome.end) << ": " << answer.outcome.log;
        return answer;
    }

    static Request request(Op op, std::vector<float> values, std::uint32_t index = 0) {
        Request request;
        request.op = op;
        request.text = TestScene::kFileName;
        request.index = index;
        request.values = std::move(values);
        return request;
    }

    std::filesystem::path m_probe;
};

TestMesh floorMesh() {
    return parallelogram({-2, -2, 0}, {4, 0, 0}, {0, 4, 0});
}

TEST_F(ReferenceProbe, SeesIntensityOverSquaredDistance) {
    TestScene scene;
    scene.addMesh(floorMesh(), kAlbedo);
    scene.addPointLight({0.5, 0, 2}, {8, 4, 2});
    // Down on the floor at (-0.25, 0.5).
    const ProbeAnswer answer = ask(scene, {request(Op::Radiance, {-0.25F, 0.5F, 1, 0, 0, -1})});
    ASSERT_TRUE(answer.complete()) << answer.responses[0].message;
    const double squared = 0.75 * 0.75 + 0.5 * 0.5 + 4;
    for (int c = 0; c < 3; ++c) {
        const double expected =
            kAlbedo[c] / M_PI * (8 / std::pow(2, c)) / squared * 2 / std::sqrt(squared);
        EXPECT_NEAR(double{answer.responses[0].values[static_cast<std::size_t>(c)]}, expected,
                    1e-4 * expected);
    }
}

TEST_F(ReferenceProbe, AveragesToLambertsFormulaUnderAnAreaLight) {
    constexpr std::uint32_t kCount = 20000;
    TestScene scene;
    scene.addMesh(floorMesh(), kAlbedo);
    const TestMesh light = parallelogram({-0.5, -0.5, 1.5}, {0, 1.2, 0}, {0.8, 0, 0}); // down
    scene.addLight(light, {0, 0, 0}, {{4, 4, 4}, {}, {}});
    Request radiance = request(Op::Radiance, {0.25F, -0.125F, 1, 0, 0, -1});
    radiance.repeats = kCount;
    radiance.seed = 1;
    const ProbeAnswer answer = ask(scene, {radiance});
    ASSERT_TRUE(answer.complete()) << answer.responses[0].message;
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
        const double red{answer.responses[0].values[3 * i]};
        sum += red;
        squares += red * red;
    }
    const double mean = sum / kCount;
    const double error = std::sqrt((squares / kCount - mean * mean) / kCount);
    const double expected =
        kAlbedo[0] / M_PI * 4 *
        polygonIrradiance({0.25, -0.125, 0}, {0, 0, 1},
                          {{-0.5, -0.5, 1.5}, {-0.5, 0.7, 1.5}, {0.3, 0.7, 1.5}, {0.3, -0.5, 1.5}});
    // Level 1e-6. The wrong twin is 3 % brighter.
    constexpr double kLimit = 4.9;
    EXPECT_LT(std::abs(mean - expected), kLimit * error);
    EXPECT_GT(std::abs(mean - 1.03 * expected), kLimit * error);
}

TEST_F(ReferenceProbe, SaysWhatItCannotAnswerAndGoesOn) {
    TestScene scene;
    scene.addMesh(floorMesh(), kAlbedo);
    scene.addPointLight({0, 0, 1}, {1, 1, 1});
    Request elsewhere = request(Op::SceneFacts, {});
    elsewhere.text = "missing.xml";
    const ProbeAnswer answer = ask(
        scene, {request(Op::MeshDensity, {0, 0, 0}, 1), elsewhere, request(Op::SceneFacts, {})});
    EXPECT_FALSE(answer.complete());
    EXPECT_EQ(answer.responses[0].state, State::Threw);
    EXPECT_NE(answer.responses[0].message.find("no such mesh"), std::string::npos);
    EXPECT_EQ(answer.responses[1].state, State::Threw);
    EXPECT_NE(answer.responses[1].message.find("missing.xml"), std::string::npos);
    EXPECT_EQ(answer.responses[2].values, (std::vector<float>{1, 1, 1, 0, 1}));
}

} // namespace

} // namespace grader
