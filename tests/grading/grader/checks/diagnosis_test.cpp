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
