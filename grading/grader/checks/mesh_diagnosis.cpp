// SPDX-License-Identifier: MIT
#include "mesh_diagnosis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace grader {

namespace {

constexpr std::size_t kPerFace = std::size_t{kCellsPerSide} * kCellsPerSide;
constexpr int kSimulationSide = 128;
constexpr int kPermutations[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

Vector3d permuted(const Vector3d &weights, std::size_t permutation) {
    const auto &order = kPermutations[permutation];
    return {weights[order[0]], weights[order[1]], weights[order[2]]};
}

Vector3d bySquareRoot(double u, double v) {
    const double s = std::sqrt(u);
    return {1 - s, v * s, s - v * s};
}

Vector3d byFolding(double u, double v) {
    return u + v > 1 ? Vector3d(1 - u, 1 - v, u + v - 1) : Vector3d(u, v, 1 - u - v);
}

/// Triangle and weights that wrong code would give for two random numbers.
struct WrongPoint {
    std::size_t face = 0;
    Vector3d weights;
};

using WrongSampler = std::function<WrongPoint(double u, double v, double other)>;

/// Frequencies of the cells, each sum 1.
std::vector<double> simulate(const TestMesh &mesh, const WrongSampler &sampler,
                             std::size_t permutation) {
    std::vector<double> cells(mesh.faces.size() * kPerFace);
    constexpr double kCount = double{kSimulationSide} * kSimulationSide;
    for (int i = 0; i < kSimulationSide; ++i) {
        for (int j = 0; j < kSimulationSide; ++j) {
            const double u = (i + 0.5) / kSimulationSide;
            const double v = (j + 0.5) / kSimulationSide;
            const double other = std::fmod((i * kSimulationSide + j) * 0.6180339887498949, 1.0);
            const WrongPoint point = sampler(u, v, other);
            MeshSample sample;
            sample.face = point.face;
            sample.weights = permuted(point.weights, permutation);
            cells[cellOf(sample)] += 1 / kCount;
        }
    }
    return cells;
}

/// Symmetric chi^2 distance of two distributions, in [0, 2].
double distance(const std::vector<double> &p, const std::vector<double> &q) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p[i] + q[i] > 0)
            sum += (p[i] - q[i]) * (p[i] - q[i]) / (p[i] + q[i]);
    }
    return sum;
}

/// Where each face ends when they are laid end to end by their parts of the area.
std::vector<double> endsOfFaces(const TestMesh &mesh) {
    const double total = mesh.area();
    std::vector<double> ends(mesh.faces.size());
    double sum = 0;
    for (std::size_t face = 0; face < ends.size(); ++face) {
        sum += mesh.area(face) / total;
        ends[face] = sum;
    }
    return ends;
}

std::size_t faceAt(const std::vector<double> &ends, double u) {
    const auto found = std::upper_bound(ends.begin(), ends.end() - 1, u);
    return static_cast<std::size_t>(found - ends.begin());
}

struct WrongWay {
    const char *diagnosis;
    WrongSampler sampler;
    bool isUniformInFace = false; ///< then the order of the vertices makes no difference
};

std::vector<WrongWay> wrongWays(const TestMesh &mesh) {
    std::vector<WrongWay> ways;
    const std::vector<double> ends = endsOfFaces(mesh);
    const std::size_t count = mesh.faces.size();
    for (std::size_t face = 0; face < count; ++face)
        ways.push_back({"mesh.first_triangle_only",
                        [=](double u, double v, double) {
                            return WrongPoint{face, bySquareRoot(u, v)};
                        },
                        true});
    ways.push_back({"mesh.triangles_by_number",
                    [=](double u, double v, double other) {
                        return WrongPoint{
                            static_cast<std::size_t>(other * static_cast<double>(count)),
                            bySquareRoot(u, v)};
                    },
                    true});
    for (const auto warp : {bySquareRoot, byFolding}) {
        ways.push_back({"mesh.sample_not_rescaled", [ends, warp](double u, double v, double) {
                            return WrongPoint{faceAt(ends, u), warp(u, v)};
                        }});
        ways.push_back({"mesh.sample_not_rescaled", [ends, warp](double u, double v, double) {
                            return WrongPoint{faceAt(ends, u), warp(v, u)};
                        }});
    }
    const auto inTriangle = [&](Vector3d (*weights)(double, double)) {
        ways.push_back(
            {"mesh.not_uniform_in_triangle", [ends, weights](double u, double v, double other) {
                 return WrongPoint{faceAt(ends, other), weights(u, v)};
             }});
    };
    inTriangle([](double u, double v) { // divided by the sum, with what is left over
        const Vector3d weights(u, v, std::fmod(256 * u, 1.0));
        return Vector3d(weights / weights.sum());
    });
    inTriangle([](double u, double v) { // without the square root
        return Vector3d(1 - u, v * u, u - v * u);
    });
    return ways;
}

} // namespace

std::size_t cellOf(const MeshSample &sample) {
    const auto [u, v] = sample.unitSquare();
    const auto bin = [](double x) {
        return std::clamp(static_cast<int>(x * kCellsPerSide), 0, kCellsPerSide - 1);
    };
    return sample.face * kPerFace + static_cast<std::size_t>(bin(u) * kCellsPerSide + bin(v));
}

std::vector<double> uniformCells(const TestMesh &mesh, double count) {
    std::vector<double> expected(mesh.faces.size() * kPerFace);
    const double perArea = count / mesh.area() / static_cast<double>(kPerFace);
    for (std::size_t face = 0; face < mesh.faces.size(); ++face)
        std::fill_n(expected.begin() + static_cast<std::ptrdiff_t>(face * kPerFace), kPerFace,
                    perArea * mesh.area(face));
    return expected;
}

MeshGuesses guessCells(const TestMesh &mesh, const std::vector<double> &counts, double asked) {
    double total = 0;
    for (const double count : counts)
        total += count;
    if (total < 0.5 * asked)
        return {{"mesh.off_surface", 0.9}};
    std::vector<double> observed = counts;
    for (double &cell : observed)
        cell /= total;
    const double error = distance(observed, uniformCells(mesh, 1));
    const double noise = 0.5 * static_cast<double>(counts.size()) / total;
    MeshGuesses guesses;
    for (const WrongWay &way : wrongWays(mesh)) {
        double nearest = error;
        const std::size_t orders = way.isUniformInFace ? 1 : std::size(kPermutations);
        for (std::size_t i = 0; i < orders; ++i)
            nearest = std::min(nearest, distance(observed, simulate(mesh, way.sampler, i)));
        const double fit = 1 - std::max(0.0, nearest - noise) / error;
        if (fit >= 0.4)
            guesses.push_back({way.diagnosis, std::min(1.0, fit)});
    }
    guesses.push_back({"mesh.not_uniform_in_triangle", kVagueFit});
    return guesses;
}

MeshGuesses guessPositions(const TestMesh &, const std::vector<MeshSample> &samples) {
    const auto bad = std::count_if(samples.begin(), samples.end(), [](const MeshSample &sample) {
        return !sample.position.allFinite();
    });
    return {{bad > 0 ? "mesh.not_finite" : "mesh.off_surface", 0.9}};
}

MeshGuesses guessNormals(const TestMesh &mesh, const std::vector<MeshSample> &samples) {
    constexpr double kTolerance = 0.01;
    constexpr double kUnsure = 0.2;
    double flipped = 0;
    double notUnit = 0;
    double ofFace = 0;
    double either = 0; // opposite vertex normals: whether they are flipped or ignored
    for (const MeshSample &sample : samples) {
        const Vector3d expected = expectedNormal(mesh, sample);
        const double part = 1 / static_cast<double>(samples.size());
        const double length = sample.normal.norm();
        const bool isFlipped = (sample.normal + expected).norm() < kTolerance;
        const bool isOfFace =
            !mesh.normals.empty() &&
            (sample.normal - mesh.geometricNormal(sample.face)).norm() < kTolerance;
        flipped += isFlipped ? part : 0;
        ofFace += isOfFace ? part : 0;
        either += isFlipped && isOfFace ? part : 0;
        notUnit += std::abs(length - 1) > kTolerance && length > 0 &&
                           (sample.normal / length - expected).norm() < kTolerance
                       ? part
                       : 0;
    }
    return {
        {"mesh.vertex_normals_ignored", ofFace - kUnsure * either},
        {"mesh.normal_flipped", flipped - kUnsure * either},
        {"mesh.normal_not_unit", notUnit},
        {mesh.normals.empty() ? "mesh.normal_flipped" : "mesh.normal_not_interpolated", kVagueFit}};
}

MeshGuesses guessUvs(const TestMesh &mesh, const std::vector<MeshSample> &samples) {
    double best = 0;
    for (std::size_t permutation = 1; permutation < std::size(kPermutations); ++permutation) {
        double matching = 0;
        for (MeshSample sample : samples) {
            sample.weights = permuted(sample.weights, permutation);
            matching += (sample.uv - expectedUv(mesh, sample)).norm() < 2e-3 ? 1 : 0;
        }
        best = std::max(best, matching / static_cast<double>(samples.size()));
    }
    return {{"mesh.uv_permuted", best}, {"mesh.uv_wrong", kVagueFit}};
}

MeshGuesses guessMeshDensity(const TestMesh &mesh, double ratio) {
    constexpr double kRounding = 2e-5; // areas may be near 1/2 or each other by chance
    const double area = mesh.area();

    const struct {
        double ratio;
        const char *diagnosis;
    } known[] = {
        {area * area, "mesh.pdf_is_area"},
        {area, "mesh.pdf_one"},
        {0, "mesh.pdf_zero"},
    };

    const auto isNear = [&](double target) {
        return std::abs(ratio - target) <= kRounding * std::max(std::abs(target), 1e-3);
    };
    for (const auto &row : known) {
        if (isNear(row.ratio))
            return {{row.diagnosis, 1}};
    }
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        if (isNear(area / mesh.area(face)) || isNear(area * mesh.area(face)))
            return {{"mesh.pdf_of_one_triangle", 1}};
    }
    return {{"mesh.pdf_factor", 0.6}};
}

} // namespace grader
