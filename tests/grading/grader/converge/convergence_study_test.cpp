// SPDX-License-Identifier: MIT
#include <grader/converge/convergence_report.h>
#include <grader/converge/hand_in_renderer.h>
#include <grader/error.h>
#include <grader/text_file.h>
#include <statistics/random.h>
#include <support/schema_checker.h>
#include <support/work_folder.h>

#include <gtest/gtest.h>

#include <cmath>

namespace grader {
namespace {

using Json = nlohmann::json;

constexpr int kWidth = 60;
constexpr int kHeight = 40;

ConvergencePlan plan() {
    ConvergencePlan plan;
    SceneFile scene;
    scene.name = "/scenes/cbox_ems.xml";
    scene.integrator = "direct_ems";
    scene.width = 3;
    scene.height = 2;
    plan.scenes = {scene};
    plan.samples = {2, 8, 32};
    plan.replicates = 6;
    plan.width = kWidth;
    plan.seed = "1";
    return plan;
}

/// Renders what a plan asks for: samples of variance `variance` around 1, from the seed that the
/// plan gave the file.
class Renderer {
public:
    Renderer(const ConvergencePlan &plan, bool reuses)
        : m_images(imagesOf(plan)), m_reuses(reuses) {}

    protocol::Image operator()(const std::filesystem::path &file) const {
        for (const ReferenceImage &image : m_images) {
            if ("/out/" + image.file == file)
                return render(image);
        }
        throw GraderError(file.string() + ": not planned");
    }

private:
    protocol::Image render(const ReferenceImage &image) const {
        const double variance = image.integrator == "direct_mats" ? 4 : 1;
        statistics::Random random(static_cast<std::uint64_t>(image.seed));
        const auto pixels = static_cast<std::size_t>(image.width * image.height);
        protocol::Image result{"exr", image.width, image.height, {}, {}};
        result.attributes["cpuSeconds"] = std::to_string(0.5 * image.samplesPerPixel);
        const auto add = [&](const std::string &name, const auto &value) {
            protocol::Channel channel{name, {}};
            for (std::size_t i = 0; i < pixels; ++i)
                channel.values.push_back(static_cast<float>(value()));
            result.channels.push_back(std::move(channel));
        };
        const bool isReference = image.file.find("reference") != std::string::npos;
        const double used = m_reuses && !isReference ? 2 : image.samplesPerPixel;
        for (const std::string name : {"R", "G", "B"}) {
            add("mean." + name, [&] {
                double noise = -6;
                for (int k = 0; k < 12; ++k)
                    noise += random.nextDouble();
                return 1 + std::sqrt(variance / used) * noise;
            });
            add("variance." + name, [&] { return variance; });
            add("third." + name, [] { return 0; });
        }
        add("count.Y", [&] { return image.samplesPerPixel; });
        return result;
    }

    std::vector<ReferenceImage> m_images;
    bool m_reuses;
};

TEST(ImagesOf, AreHalvesThenReplicatesEachWithASeedOfItsOwn) {
    const std::vector<ReferenceImage> images = imagesOf(plan());
    ASSERT_EQ(images.size(), 2U + 3 * 6);
    EXPECT_EQ(images[0].file, "cbox_ems/reference_a.exr");
    EXPECT_EQ(images[0].samplesPerPixel, 4 * 32);
    EXPECT_EQ(images[2].file, "cbox_ems/direct_ems_2_0.exr");
    EXPECT_EQ(images[2].height, kHeight);
    std::set<int> seeds;
    for (const ReferenceImage &image : images)
        seeds.insert(image.seed);
    EXPECT_EQ(seeds.size(), images.size());
    ConvergencePlan given = plan();
    given.references = {"a.exr", "b.exr"};
    EXPECT_EQ(imagesOf(given).size(), 18U);
}

TEST(ImagesOf, AddAHandInThatIsRenderedAnewWhenItChanges) {
    ConvergencePlan against = plan();
    against.against = ComparedHandIn{"p2_1_2", "abc"};
    const std::vector<ReferenceImage> images = imagesOf(against);
    ASSERT_EQ(images.size(), 2U + 2 * 3 * 6);
    EXPECT_EQ(images.back().file, "cbox_ems/handed_in_32_5.planes");
    EXPECT_EQ(images[0].integrator, "direct_ems"); // the reference stays ours
    const ReferenceImage before = images.back();
    against.against->digest = "def";
    EXPECT_FALSE(isSameRender(before, imagesOf(against).back()));
    const std::vector<Convergence> all = evaluate(against, "/out", Renderer(against, false));
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[1].label, "cbox_ems p2_1_2");
    EXPECT_TRUE(all[1].fit.isMonteCarlo());
    EXPECT_TRUE(all[1].gain);
}

TEST(Planes, AreReadAsTheyWereWritten) {
    const support::WorkFolder folder;
    const protocol::Image image{"exr", 2, 1, {{"count.Y", {4, 4}}, {"mean.R", {1, 2}}}, {}};
    writeTextFile(folder.path() / "a.planes",
                  protocol::encode(protocol::ImageAnswer{image, {}, {}}));
    EXPECT_EQ(readPlanes(folder.path() / "a.planes").channel("mean.R")->values,
              (std::vector<float>{1, 2}));
    folder.write("b.planes", "nonsense");
    EXPECT_THROW(readPlanes(folder.path() / "b.planes"), GraderError);
}

TEST(Evaluate, FindsSlopeVarianceCostAndGain) {
    ConvergencePlan both = plan();
    both.integrators = {"direct_ems", "direct_mats"};
    const std::vector<Convergence> all = evaluate(both, "/out", Renderer(both, false));
    ASSERT_EQ(all.size(), 2U);
    for (const Convergence &one : all) {
        EXPECT_TRUE(one.fit.isMonteCarlo()) << one.label << ' ' << one.fit.slope;
        EXPECT_NEAR(one.cpuSeconds, 0.5, 1e-6);
        // Level 1e-6.
        EXPECT_NEAR(one.betweenWithin->ratio, 1, 4.9 * one.betweenWithin->standardError);
    }
    EXPECT_NEAR(all[0].variance, 1, 1e-6);
    EXPECT_NEAR(all[0].efficiency, 2, 1e-6);
    EXPECT_FALSE(all[0].gain);
    EXPECT_NEAR(all[1].gain->ratio, 0.25, 1e-6);
    EXPECT_EQ(all[1].label, "cbox_ems direct_mats");
}

TEST(Evaluate, ConvictsAStreamThatIsUsedAgain) {
    const std::vector<Convergence> all = evaluate(plan(), "/out", Renderer(plan(), true));
    EXPECT_TRUE(all[0].fit.isOtherwise()) << all[0].fit.slope;
    EXPECT_STREQ(convergenceVerdict(all[0].fit), "does not");
    // 16 times the variance.
    EXPECT_GT(all[0].betweenWithin->ratio, 1.05 + 4.9 * all[0].betweenWithin->standardError);
}

TEST(Evaluate, ComparesTheNoiseOfRendersOfOneImageOnly) {
    ConvergencePlan two = plan();
    SceneFile other = two.scenes[0];
    other.name = "/scenes/table_ems.xml";
    two.scenes.push_back(other);
    const Renderer renderer(two, false);
    const auto brighter = [&renderer](const std::filesystem::path &file) {
        protocol::Image image = renderer(file);
        if (file.string().find("table_ems") == std::string::npos)
            return image;
        for (protocol::Channel &channel : image.channels) {
            if (channel.name.rfind("mean.", 0) == 0) {
                for (float &value : channel.values)
                    value += 1;
            }
        }
        return image;
    };
    EXPECT_TRUE(evaluate(two, "/out", renderer)[1].gain);
    EXPECT_FALSE(evaluate(two, "/out", brighter)[1].gain);
}

TEST(Evaluate, NamesWhatHasNoMoments) {
    const auto load = [](const std::filesystem::path &) {
        return protocol::Image{"exr", 1, 1, {{"R", {1}}}, {}};
    };
    try {
        evaluate(plan(), "/out", load);
        FAIL();
    } catch (const GraderError &error) {
        EXPECT_NE(std::string(error.what()).find("reference_a.exr: has no moments"),
                  std::string::npos);
    }
}

TEST(ConvergenceReport, TellsTheSameInTableJsonAndPlot) {
    const std::vector<Convergence> all = evaluate(plan(), "/out", Renderer(plan(), false));
    const std::string table = convergenceTable(all);
    EXPECT_NE(table.find("cbox_ems direct_ems"), std::string::npos) << table;
    EXPECT_NE(table.find("converges as 1/sqrt(n)"), std::string::npos) << table;
    const auto schema =
        support::SchemaChecker::ofFile("grading/grader/converge/convergence.schema.json");
    Json json = Json::parse(convergenceJson(plan(), all));
    EXPECT_EQ(schema.check(json), "");
    EXPECT_EQ(json["curves"][0]["points"].size(), 3U);
    json["curves"][0]["points"][0].erase("rmse");
    EXPECT_EQ(schema.check(json), "$.curves[0].points[0]: lacks rmse");
    const plot::LogLogPlot plot = convergencePlot(all);
    ASSERT_EQ(plot.series.size(), 1U);
    EXPECT_EQ(plot.series[0].points.size(), 3U);
}

} // namespace
} // namespace grader
