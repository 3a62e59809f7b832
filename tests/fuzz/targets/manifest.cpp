// SPDX-License-Identifier: MIT
//
// Small files that norigrade writes beside others and reads again: the manifest of references and
// the stamp of a rubric that was calibrated.
#include <grader/app/frozen_rubric.h>
#include <grader/error.h>
#include <grader/references/manifest.h>

#include <fstream>

#include "../target.h"

namespace {

void put(const std::filesystem::path &file, std::string_view bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

} // namespace

void fuzz::run(std::string_view bytes) {
    using namespace grader;
    static const ScratchFolder folder;
    put(folder.path() / "manifest.toml", bytes);
    try {
        for (const ReferenceImage &image : readManifest(folder.path()))
            require(image.samplesPerPixel >= 0 && image.width >= 0 && image.height >= 0,
                    "counts are counts");
    } catch (const GraderError &) {
    }
    const std::filesystem::path rubric = folder.path() / "rubric.toml";
    put(frozenFile(rubric), bytes);
    require(!describeFrozen(rubric, {}).empty(), "a stamp is spoken of");
}
