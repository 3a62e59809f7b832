// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/mesh_samples.h>
#include <grader/diagnosis/guess.h>

#include <cstddef>
#include <vector>

namespace grader {

using MeshGuesses = std::vector<Guess>;

constexpr int kCellsPerSide = 8; ///< of a triangle, per coordinate of MeshSample::unitSquare()

/// Cells of equal area per triangle: triangle by triangle, in each a grid of the barycentric chart.
std::size_t cellOf(const MeshSample &sample);

/// What `count` uniform points put into each cell, on average.
std::vector<double> uniformCells(const TestMesh &mesh, double count);

// What would explain what was measured; each looks at wrong numbers only.
/// \param asked  points that were asked for: those off the mesh are in no cell
MeshGuesses guessCells(const TestMesh &mesh, const std::vector<double> &counts, double asked);
MeshGuesses guessPositions(const TestMesh &mesh, const std::vector<MeshSample> &samples);
MeshGuesses guessNormals(const TestMesh &mesh, const std::vector<MeshSample> &samples);
MeshGuesses guessUvs(const TestMesh &mesh, const std::vector<MeshSample> &samples);

/// \param ratio  returned density times the area
MeshGuesses guessMeshDensity(const TestMesh &mesh, double ratio);

} // namespace grader
