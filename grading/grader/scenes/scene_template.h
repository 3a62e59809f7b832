// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/request.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// What two scenes of one template and one seed may differ in.
struct SceneVariation {
    double radianceFactor = 1; ///< of every `{radiance}`
    std::vector<std::size_t> darkLights =
        {};            ///< of these, counted from 0, in order: the radiance is 0
    unsigned pose = 0; ///< another number is another rigid transform
    int cuts = 0;      ///< more pieces per side of every `{mesh}`
};

/// A scene as a Nori XML file with placeholders in braces, filled in anew for every seed. All
/// positions of a template are in a frame of its own; the scene is moved as a whole, camera and
/// all, by a random rigid transform.
///
/// | placeholder | becomes |
/// | --- | --- |
/// | `{number LOW HIGH}` | a number between the two |
/// | `{color LOW HIGH}` | three of them |
/// | `{radiance LOW HIGH}` | the same, times SceneVariation::radianceFactor, or 0 |
/// | `{point X Y Z REACH}` | the point, up to REACH away along each axis, moved |
/// | `{direction X Y Z}` | the direction, turned |
/// | `{mesh parallelogram CORNER A B}` | name of an OBJ file: the parallelogram, moved, cut at
/// random | | `{mesh block CENTER SIZE TURN}` | a box with its normals outside, turned about z
/// [degrees] | | `{mesh sphere CENTER RADIUS}` | a sphere with vertex normals | | `{file NAME}` |
/// name of a copy of the file, which is named relative to the template |
class SceneTemplate {
public:
    /// \throws GraderError  if the file cannot be read
    explicit SceneTemplate(std::filesystem::path file);

    /// \param name   of the scene
    /// \param text   of the template; files are looked for in the working folder
    SceneTemplate(std::filesystem::path name, std::string text);

    /// The XML and what it names, below the folder `folder` (empty: at the top).
    /// \throws GraderError  with file and line, on a placeholder that is none of the above
    std::vector<protocol::File> fill(std::uint64_t seed, const SceneVariation &variation = {},
                                     const std::string &folder = "") const;

    /// How many `{radiance}` there are.
    std::size_t lightCount() const;

private:
    std::filesystem::path m_file;
    std::string m_text;
};

} // namespace grader
