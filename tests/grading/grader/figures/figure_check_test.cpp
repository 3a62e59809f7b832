// SPDX-License-Identifier: MIT
#include <grader/figures/figure_check.h>
#include <grader/figures/film_patches.h>
#include <grader/scenes/scene_bundle.h>
#include <statistics/random.h>
#include <support/work_folder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace grader {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 72;

/// What the program that was handed in draws: exponential samples around a picture of each scene.
double pictureOf(const std::string &scene, double x, double y) {
    if (scene.find("stripes") != std::string::npos)
        return std::fmod(x, 24) < 12 ? 0.1 : 3;
    return 0.1 + 0.02 * y;
}

std::vector<float> radianceOf(const std::string &scene, const std::vector<float> &points,
                              std::uint64_t seed, double factor = 1) {
    statistics::Random random(seed);
    std::vector<float> radiance;
    for (std::size_t i = 0; i < points.size(); i += 2) {
        const double mean = factor * pictureOf(scene, double{points[i]}, double{points[i + 1]});
        for (int c = 0; c < 3; ++c)
            radiance.push_back(static_cast<float>(-mean * std::log(1 - random.nextDouble())));
    }
    return radiance;
}

class CheckFigures : public testing::Test {
protected:
    void SetUp() override {
        for (const char *name : {"ramp", "stripes"})
            m_folder.write(std::string(name) + ".xml",
                           "<scene id=\"" + std::string(name) +
                               "\"><camera type=\"perspective\"><integer name=\"width\" "
                               "value=\"96\"/><integer name=\"height\" value=\"72\"/></camera>"
                               "</scene>");
    }

    protocol::Image render(const std::string &scene, int samples, std::uint64_t seed) const {
        PatchPlan whole;
        whole.width = kWidth;
        whole.height = kHeight;
        whole.patches = {{0, 0, kWidth, kHeight}};
        const std::vector<float> points = filmPoints(whole, samples, seed);
        const PatchPixels pixels =
            develop(whole, points, radianceOf(scene, points, seed + 1), samples)[0];
        protocol::Image image{"exr", kWidth, kHeight, {{"B", {}}, {"G", {}}, {"R", {}}}, {}};
        for (const auto &pixel : pixels) {
            for (std::size_t c = 0; c < 3; ++c)
                image.channels[2 - c].values.push_back(pixel[c]);
        }
        return image;
    }

    void add(const std::string &path, const protocol::Image &image) {
        m_images[path] = image;
        m_submission.files.push_back({path, path, FileRole::Figure, "figure", path});
    }

    /// \param given  whether the scenes are those that were handed out
    std::map<std::string, FigureResult> check(bool given = true) {
        const FigureScenes scenes(m_folder.path(), given);
        FigureCheck check{scenes, "seed", {}, {}, 2, [](double) {
                          }};
        check.decode = [this](std::string_view bytes) -> ImageReading {
            const auto found = m_images.find(std::string(bytes));
            if (found == m_images.end())
                return NoImage{protocol::ImageFault::Broken, "cut short"};
            return found->second;
        };
        check.ask = [this](const protocol::RequestGroup &group) {
            ++m_asked;
            ProbeAnswer answer;
            for (const protocol::Request &request : group.requests) {
                protocol::Response response;
                response.state = m_throws ? protocol::State::Threw : protocol::State::Done;
                response.message = "not implemented";
                if (!m_throws)
                    response.values =
                        radianceOf(group.files.front().bytes, request.values, request.seed);
                answer.responses.push_back(response);
            }
            if (m_endless) {
                answer.responses.assign(group.requests.size(), {});
                answer.outcome.end = BoxTimedOut{true};
            }
            return answer;
        };
        std::map<std::string, FigureResult> results;
        for (FigureResult &result : checkFigures(m_submission, check)) {
            const std::string path = result.path;
            results[path] = std::move(result);
        }
        return results;
    }

    support::WorkFolder m_folder;
    Submission m_submission;
    std::map<std::string, protocol::Image> m_images;
    std::atomic<int> m_asked{0};
    bool m_throws = false;
    bool m_endless = false;
};

TEST_F(CheckFigures, MatchesWhatTheCodeRenders) {
    add("figures/ramp_16.exr", render("ramp", 16, 1));
    add("figures/Stripes 4spp.exr", render("stripes", 4, 2));
    auto results = check();
    EXPECT_EQ(results["figures/ramp_16.exr"].verdict, FigureVerdict::Match)
        << results["figures/ramp_16.exr"].message;
    EXPECT_FALSE(results["figures/ramp_16.exr"].flag);
    EXPECT_EQ(results["figures/ramp_16.exr"].samples, 16);
    EXPECT_GT(results["figures/ramp_16.exr"].mde, 0);
    const FigureResult &near = results["figures/Stripes 4spp.exr"];
    EXPECT_EQ(near.verdict, FigureVerdict::Match) << near.message;
    EXPECT_NE(near.message.find("taken for stripes_4"), std::string::npos) << near.message;
    EXPECT_EQ(results["serapis_ems_1.exr"].verdict, FigureVerdict::Missing);
}

TEST_F(CheckFigures, NamesTheSceneThatIsShownInstead) {
    add("figures/ramp_16.exr", render("stripes", 16, 1));
    for (const bool given : {true, false}) {
        const FigureResult found = check(given)["figures/ramp_16.exr"];
        EXPECT_EQ(found.verdict, FigureVerdict::DifferentScene) << found.message;
        EXPECT_TRUE(found.flag);
        EXPECT_NE(found.message.find("shows stripes, not ramp"), std::string::npos);
    }
}

TEST_F(CheckFigures, AccuseNobodyOverScenesThatMayNotBeTheirs) {
    protocol::Image foreign = render("ramp", 16, 1);
    for (protocol::Channel &channel : foreign.channels) {
        for (std::size_t i = 0; i < channel.values.size(); ++i)
            channel.values[i] *= (i / kWidth / 9 + i % kWidth / 9) % 2 == 0 ? 5.0F : 0.3F;
    }
    add("figures/ramp_16.exr", foreign);
    FigureResult found = check(true)["figures/ramp_16.exr"];
    EXPECT_EQ(found.verdict, FigureVerdict::DifferentScene) << found.message;
    EXPECT_TRUE(found.flag);
    found = check(false)["figures/ramp_16.exr"];
    EXPECT_EQ(found.verdict, FigureVerdict::CannotTell) << found.message;
    EXPECT_FALSE(found.flag);
    EXPECT_NE(found.message.find("--scenes"), std::string::npos);
}

TEST_F(CheckFigures, FindOtherNoiseAndWhatWasCutOff) {
    add("figures/ramp_64.exr", render("ramp", 4, 1));
    protocol::Image clamped = render("stripes", 16, 2);
    for (protocol::Channel &channel : clamped.channels) {
        for (float &value : channel.values)
            value = std::min(value, 1.0F);
    }
    add("figures/stripes_16.exr", clamped);
    auto results = check();
    EXPECT_EQ(results["figures/ramp_64.exr"].verdict, FigureVerdict::DifferentNoise)
        << results["figures/ramp_64.exr"].message;
    EXPECT_NEAR(results["figures/ramp_64.exr"].noise, 16, 4);
    EXPECT_EQ(results["figures/stripes_16.exr"].verdict, FigureVerdict::Clamped)
        << results["figures/stripes_16.exr"].message;
}

TEST_F(CheckFigures, TakeAPngForWhatItsExrIs) {
    const protocol::Image exr = render("ramp", 16, 1);
    protocol::Image png = exr;
    png.format = "png";
    for (protocol::Channel &channel : png.channels) {
        for (float &value : channel.values)
            value = std::min(value, 1.0F);
    }
    add("figures/ramp_16.exr", exr);
    add("figures/ramp_16.png", png);
    add("figures/stripes_16.exr", render("stripes", 16, 2));
    add("figures/stripes_16.png", png);
    auto results = check();
    EXPECT_EQ(results["figures/ramp_16.png"].verdict, FigureVerdict::Match);
    EXPECT_FALSE(results["figures/ramp_16.png"].flag);
    const FigureResult &other = results["figures/stripes_16.png"];
    EXPECT_TRUE(other.flag);
    EXPECT_NE(other.message.find("does not show the EXR"), std::string::npos) << other.message;
    EXPECT_NE(other.message.find("same pixels as ramp_16.png"), std::string::npos) << other.message;
}

TEST_F(CheckFigures, SayWhatCannotBeCompared) {
    m_submission.files.push_back(
        {"figures/ramp_4.exr", "ramp_4.exr", FileRole::Figure, "figure", "broken"});
    m_submission.files.push_back(
        {"figures/a.jpg", "a.jpg", FileRole::Figure, "figure", "whatever"});
    add("figures/UniformTriangle.png", render("ramp", 1, 1));
    add("figures/tiny_stripes_1.exr", render("ramp", 1, 1));
    protocol::Image grey = render("ramp", 1, 1);
    grey.channels = {{"Y", grey.channels[0].values}};
    add("figures/stripes_1.exr", grey);
    protocol::Image holes = render("ramp", 16, 5);
    holes.channels[0].values[17] = std::numeric_limits<float>::quiet_NaN();
    add("figures/ramp_16.exr", holes);
    auto results = check();
    EXPECT_EQ(results["figures/ramp_4.exr"].verdict, FigureVerdict::Unreadable);
    EXPECT_TRUE(results["figures/ramp_4.exr"].flag);
    EXPECT_EQ(results["figures/a.jpg"].verdict, FigureVerdict::NotCompared);
    EXPECT_EQ(results["figures/UniformTriangle.png"].verdict, FigureVerdict::NotCompared);
    EXPECT_EQ(results["figures/stripes_1.exr"].verdict, FigureVerdict::Unreadable);
    EXPECT_NE(results["figures/ramp_16.exr"].message.find("1 of its values are not finite"),
              std::string::npos);
}

TEST_F(CheckFigures, GiveUpOnCodeThatThrowsOrDoesNotEnd) {
    for (int i = 1; i <= 9; ++i)
        add("figures/ramp_" + std::to_string(i) + ".exr", render("ramp", 1, 1));
    m_throws = true;
    FigureResult found = check()["figures/ramp_3.exr"];
    EXPECT_EQ(found.verdict, FigureVerdict::CannotTell);
    EXPECT_NE(found.message.find("not implemented"), std::string::npos);
    m_throws = false;
    m_endless = true;
    m_asked = 0;
    found = check()["figures/ramp_3.exr"];
    EXPECT_EQ(found.verdict, FigureVerdict::CannotTell) << found.message;
    EXPECT_LE(m_asked, 6);
}

TEST_F(CheckFigures, AreTheSameForASeed) {
    add("figures/ramp_16.exr", render("ramp", 16, 1));
    const FigureResult first = check()["figures/ramp_16.exr"];
    const FigureResult second = check()["figures/ramp_16.exr"];
    EXPECT_EQ(first.message, second.message);
    EXPECT_EQ(first.p, second.p);
}

TEST(SceneBundle, BringsEverythingThatASceneNames) {
    const std::string scenes = std::string(NORI_SOURCE_DIR) + "/scenes/assignment-2/";
    const SceneBundle own = readSceneBundle(scenes + "bunny/bunny_ems.xml");
    EXPECT_EQ(own.width, 768);
    ASSERT_EQ(own.files.size(), 3U); // the scene, the bunny, and one quad for two meshes
    EXPECT_EQ(own.files[0].bytes.find(".."), std::string::npos);
    EXPECT_TRUE(own.film);
    const SceneBundle small = readSceneBundle(scenes + "bunny/bunny_ems.xml", ImageSize{96, 72});
    EXPECT_EQ(small.width, 768);
    EXPECT_NE(small.files[0].bytes.find("value=\"96\""), std::string::npos);
    EXPECT_THROW(readSceneBundle(scenes + "nothing.xml"), std::runtime_error);
}

} // namespace
} // namespace grader
