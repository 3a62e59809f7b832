// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <catalog/density_mistakes.h>
#include <catalog/warp_catalog.h>
#include <catalog/warp_mistakes.h>
#include <grader/checks/direct_ems_diagnosis.h>
#include <grader/checks/emitter_diagnosis.h>
#include <grader/checks/mesh_diagnosis.h>
#include <grader/checks/warp_diagnosis.h>
#include <grader/diagnosis/catalogue.h>

#include <gtest/gtest.h>

#include <cmath>

namespace grader {

namespace {

std::string firstOf(const std::vector<Guess> &guesses) {
    const std::vector<Guess> best = bestGuesses(guesses);
    return best.empty() ? "" : best.front().id;
}

/// Exact means of `values` with hardly any noise.
RadianceMoments imageOf(const std::vector<Vector3d> &values) {
    RadianceMoments image;
    for (std::size_t c = 0; c < 3; ++c) {
        for (const Vector3d &value : values)
            image[c].push_back({1e6, value[static_cast<Eigen::Index>(c)], 1, 0});
    }
    return image;
}

std::vector<Vector3d> someRadiance(double factor) {
    SceneRandom random(3);
    std::vector<Vector3d> values;
    for (int i = 0; i < 64; ++i)
        values.emplace_back(factor * random.color(0.5, 2));
    return values;
}

} // namespace

TEST(WarpDiagnosis, covers_every_mistake_of_the_catalogue) {
    for (const catalog::WarpMistake &mistake : catalog::warpMistakes())
        EXPECT_NE(findDiagnosis(warpDiagnosis(mistake.warpId, mistake.id)), nullptr)
            << mistake.warpId << " " << mistake.id;
    for (const catalog::DensityMistake &mistake : catalog::densityMistakes())
        EXPECT_NE(findDiagnosis(warpDiagnosis(mistake.warpId, "pdf_" + std::string(mistake.id))),
                  nullptr)
            << mistake.warpId << " " << mistake.id;
}

TEST(WarpDiagnosis, names_a_density_by_its_ratio) {
    const catalog::WarpEntry &triangle = catalog::requireWarp("triangle");
    battery::DensityResult density;
    density.ratio = {true, 0.25, 0, "1/4"};
    EXPECT_EQ(firstOf(guessDensity(triangle, density, false)), "warp.pdf_is_area");
    density.ratio = {true, 3.14, 0, ""};
    EXPECT_EQ(firstOf(guessDensity(triangle, density, false)), "warp.pdf_factor");
    EXPECT_EQ(firstOf(guessDensity(triangle, density, true)), "warp.pdf_outside");
}

TEST(WarpDiagnosis, tells_what_a_density_is_outside) {
    const catalog::WarpEntry &triangle = catalog::requireWarp("triangle");
    battery::DensityResult density;
    density.outsideMass = density.outsideSize = 0.5;
    EXPECT_EQ(firstOf(guessDensity(triangle, density, true)), "warp.pdf_outside");
    density.outsideMass = -0.5;
    EXPECT_EQ(firstOf(guessDensity(triangle, density, true)), "warp.pdf_negative");
    density = {};
    density.outsideSize = INFINITY;
    EXPECT_EQ(firstOf(guessDensity(triangle, density, true)), "warp.pdf_not_finite");
}

TEST(GuessRadiance, names_factors_and_means) {
    const RadianceMoments right = imageOf(someRadiance(1));
    CaseDiagnoses known;
    known.lightCount = 5;
    EXPECT_EQ(firstOf(guessRadiance(imageOf(someRadiance(0.2)), right, known)),
              "ems.pick_pdf_forgotten");
    EXPECT_EQ(firstOf(guessRadiance(imageOf(someRadiance(M_PI)), right, known)), "ems.factor_pi");
    EXPECT_EQ(firstOf(guessRadiance(imageOf(someRadiance(1.37)), right, known)), "ems.factor");
    EXPECT_EQ(firstOf(guessRadiance(imageOf(someRadiance(0)), right, known)), "ems.black");
    std::vector<Vector3d> other = someRadiance(1);
    for (std::size_t i = 0; i < other.size(); ++i)
        other[i] *= 1 + 0.01 * static_cast<double>(i);
    known.hypotheses = {{"ems.no_cosine", other}};
    EXPECT_EQ(firstOf(guessRadiance(imageOf(other), right, known)), "ems.no_cosine");
}

TEST(GuessRadiance, tells_a_constant_from_a_factor) {
    std::vector<Vector3d> brighter = someRadiance(1);
    for (Vector3d &value : brighter)
        value += Vector3d(0.3, 0.3, 0.3);
    EXPECT_EQ(firstOf(guessRadiance(imageOf(brighter), imageOf(someRadiance(1)), {})),
              "ems.constant_added");
    const std::vector<Vector3d> even(64, Vector3d(0.5, 0.5, 0.5));
    const std::vector<Vector3d> tripled(64, Vector3d(1.5, 1.5, 1.5));
    EXPECT_EQ(firstOf(guessRadiance(imageOf(tripled), imageOf(even), {})), "ems.factor");
}

TEST(GuessRadiance, does_not_take_any_mean_for_a_nearly_black_image) {
    // A fiftieth is left of the image; what a wrong choice of lights would leave is as dark.
    std::vector<Vector3d> dark = someRadiance(0.02);
    for (std::size_t i = 0; i < dark.size(); i += 2)
        dark[i] *= 30;
    CaseDiagnoses known;
    known.hypotheses = {{"ems.pick_pdf_multiplied", someRadiance(0.04)}};
    EXPECT_NE(firstOf(guessRadiance(imageOf(dark), imageOf(someRadiance(1)), known)),
              "ems.pick_pdf_multiplied");
}

TEST(ChoiceMistakes, hold_a_light_alone_and_every_power_of_the_probability) {
    const std::vector<Vector3d> intensities = {{1, 2, 3}, {4, 1, 2}, {0.5, 3, 1}};
    std::vector<std::vector<Vector3d>> lights;
    SceneRandom random(5);
    for (const Vector3d &intensity : intensities) {
        std::vector<Vector3d> rays;
        for (int k = 0; k < 32; ++k)
            rays.emplace_back(random.uniform(0.2, 1) * intensity);
        lights.push_back(rays);
    }
    std::vector<Vector3d> right;
    for (std::size_t k = 0; k < 32; ++k)
        right.emplace_back(lights[0][k] + lights[1][k] + lights[2][k]);
    CaseDiagnoses known;
    known.lightCount = 3;
    known.hypotheses = choiceMistakes(lights, intensities);
    const auto first = [&](const std::vector<Vector3d> &image) {
        return firstOf(guessRadiance(imageOf(image), imageOf(right), known));
    };
    EXPECT_EQ(first(lights[1]), "ems.light_left_out");
    std::vector<Vector3d> chosen = lights[2];
    for (Vector3d &value : chosen)
        value *= 17.5 / 4.5;
    EXPECT_EQ(first(chosen), "ems.light_chosen_once");
    EXPECT_EQ(first(std::vector<Vector3d>(32, Vector3d(0.3, 0.2, 0.1))), "ems.constant_image");
    const double mean[] = {6.0 / 17.5, 7.0 / 17.5, 4.5 / 17.5}; // powers, by the mean of channels
    for (const auto &[power, diagnosis] :
         {std::pair(1, "ems.pick_pdf_forgotten"), std::pair(2, "ems.pick_pdf_multiplied"),
          std::pair(-1, "ems.pick_pdf_twice")}) {
        std::vector<Vector3d> image;
        for (std::size_t k = 0; k < 32; ++k) {
            Vector3d sum = Vector3d::Zero();
            for (std::size_t i = 0; i < 3; ++i)
                sum += std::pow(mean[i], power) * lights[i][k];
            image.push_back(sum);
        }
        EXPECT_EQ(first(image), diagnosis);
    }
}

TEST(GuessAreaDensity, finds_the_powers_of_cosine_and_distance) {
    const auto lawOf = [](double constant, double cosinePower, double distancePower) {
        SceneRandom random(7);
        std::vector<DensityRatio> ratios;
        for (int i = 0; i < 200; ++i) {
            DensityRatio row;
            row.cosine = random.uniform(0.1, 1);
            row.distance = random.uniform(0.5, 3);
            row.ratio = constant * std::pow(row.cosine, cosinePower) *
                        std::pow(row.distance, distancePower);
            ratios.push_back(row);
        }
        return firstOf(guessAreaDensity(ratios));
    };
    EXPECT_EQ(lawOf(1, 0, -1), "area.pdf_distance_not_squared");
    EXPECT_EQ(lawOf(1, 1, -2), "area.pdf_area_measure");
    EXPECT_EQ(lawOf(1, 1, 0), "area.pdf_cosine_missing");
    EXPECT_EQ(lawOf(2, 2, 0), "area.pdf_cosine_power");
    EXPECT_EQ(lawOf(3, 2, -4), "area.pdf_reciprocal");
    EXPECT_EQ(lawOf(3, 0, 0), "area.pdf_factor");
}

TEST(GuessDirections, tells_a_position_from_a_direction) {
    SceneRandom random(5);
    std::vector<EmitterSampleRow> rows;
    std::vector<EmitterSampleRow> even;
    for (int i = 0; i < 4096; ++i) {
        EmitterSampleRow row;
        row.ref = Vector3d(1.5, 0.3, -0.4);
        row.wi = (random.direction() - row.ref).normalized();
        rows.push_back(row);
        const double theta = M_PI * random.uniform();
        const double phi = 2 * M_PI * random.uniform();
        row.wi = {std::sin(theta) * std::cos(phi), std::cos(theta),
                  std::sin(theta) * std::sin(phi)};
        even.push_back(row);
    }
    EXPECT_EQ(firstOf(guessDirections(rows, true)), "environment.direction_from_point");
    EXPECT_EQ(firstOf(guessDirections(even, true)), "environment.uniform_in_map");
}

TEST(GuessCells, finds_how_triangles_are_chosen) {
    SceneRandom random(2);
    const TestMesh mesh = unequalStrip(random);
    const auto firstWith = [&](const std::vector<double> &shares) {
        std::vector<double> counts = uniformCells(mesh, 1);
        const double perFace =
            static_cast<double>(counts.size()) / static_cast<double>(shares.size());
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] = 1e6 * shares[i / static_cast<std::size_t>(perFace)] / perFace;
        return firstOf(guessCells(mesh, counts, 1e6));
    };
    std::vector<double> shares(mesh.faces.size());
    shares[1] = 1;
    EXPECT_EQ(firstWith(shares), "mesh.first_triangle_only");
    std::fill(shares.begin(), shares.end(), 1 / static_cast<double>(shares.size()));
    EXPECT_EQ(firstWith(shares), "mesh.triangles_by_number");
    std::fill(shares.begin(), shares.end(), 1e-3); // the rest of the points are elsewhere
    EXPECT_EQ(firstWith(shares), "mesh.off_surface");
}

} // namespace grader
