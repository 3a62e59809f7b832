// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// One rendered image, and what it was rendered from.
struct ReferenceImage {
    std::string file; ///< below the manifest's folder: `cbox/cbox_ems_a.exr`
    std::string scene;
    std::string sceneDigest;
    std::string integrator;
    int samplesPerPixel = 0;
    int seed = 0;
    int width = 0;
    int height = 0;
    std::string version; ///< of the program that rendered it
    std::string sha256;  ///< of the file; empty: not rendered yet
};

/// `manifest.toml` of a folder; nothing where there is none.
/// \throws GraderError  with the line, if it is damaged
std::vector<ReferenceImage> readManifest(const std::filesystem::path &folder);

/// \throws GraderError  if it cannot be written
void writeManifest(const std::filesystem::path &folder, const std::vector<ReferenceImage> &images);

/// Whether `rendered` is what `wanted` asks for. Version and bytes do not count.
bool isSameRender(const ReferenceImage &rendered, const ReferenceImage &wanted);

/// Why an entry of the manifest does not describe the file that is there; empty if it does.
std::string faultOf(const std::filesystem::path &folder, const ReferenceImage &image);

} // namespace grader
