// SPDX-License-Identifier: MIT
#include <support/probe_child.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using protocol::Op;
using protocol::State;

constexpr char kReference[] = NORI_PROBE_REFERENCE;
constexpr char kFaulty[] = NORI_PROBE_FAULTY;
constexpr char kPointLight[] =
    R"(<emitter type="pointlight"><point name="position" value="0,0,0"/>
       <color name="radiance" value="8,4,2"/></emitter>)";

/// The first pixels of the camera's image.
protocol::Request imageOn(std::uint32_t threads, std::size_t pixels = 400) {
    std::vector<float> numbers(pixels);
    std::iota(numbers.begin(), numbers.end(), 0.0F);
    protocol::Request request = test::sceneRequest(Op::Image, numbers, threads - 1);
    request.repeats = 8;
    request.seed = 3;
    return request;
}

std::vector<float> imageOf(const char *probe, const std::string &integrator,
                           std::uint32_t threads) {
    return test::askOne(probe, test::sceneFile("", integrator), imageOn(threads));
}

protocol::Request samplesOn(std::uint32_t threads) {
    std::vector<float> rows;
    for (int i = 0; i < 50; ++i)
        rows.insert(rows.end(), {static_cast<float>(i), 1, 2, 0.1F, 0.2F, 0.3F});
    protocol::Request request = test::sceneRequest(Op::EmitterSample, rows);
    request.repeats = threads;
    return request;
}

} // namespace

TEST(Threads, GiveTheAnswerOfOne) {
    const std::vector<float> image = imageOf(kFaulty, "drawing", 1);
    for (const std::uint32_t threads : {2U, 4U, 1000U})
        EXPECT_EQ(imageOf(kFaulty, "drawing", threads), image) << threads;
    const std::vector<float> samples =
        test::askOne(kReference, test::sceneFile(kPointLight), samplesOn(1));
    for (const std::uint32_t threads : {0U, 4U, 0xffffffffU}) {
        const std::vector<float> same =
            test::askOne(kReference, test::sceneFile(kPointLight), samplesOn(threads));
        ASSERT_EQ(same.size(), samples.size());
        // Unset members are no numbers, which are never equal.
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!std::isnan(samples[i])) {
                EXPECT_EQ(same[i], samples[i]) << threads << " " << i;
            }
        }
    }
}

TEST(Threads, ShowWhatTheyShare) {
    EXPECT_NE(imageOf(kFaulty, "sharing", 4), imageOf(kFaulty, "sharing", 1));
}

TEST(Threads, HandOnWhatIsThrown) {
    const protocol::RequestGroup group{
        {test::sceneFile(R"(<emitter type="faulty"><string name="mistake" value="pdf_throws"/>
                            </emitter>)")},
        {samplesOn(4)}};
    const test::ProbeRun run = test::runProbe(kFaulty, group);
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.responses[0].state, State::Threw);
    EXPECT_NE(run.responses[0].message.find("not yet implemented"), std::string::npos);
}

TEST(Threads, NeedNoRows) {
    EXPECT_TRUE(test::askOne(kFaulty, test::sceneFile("", "drawing"), imageOn(4, 0)).empty());
}
