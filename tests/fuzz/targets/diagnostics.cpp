// SPDX-License-Identifier: MIT
//
// What a compiler or linker printed about a stranger's code, who may have written half of it.
#include <grader/build/diagnostics.h>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    using namespace grader;
    const bool link = !bytes.empty() && bytes.front() == 'L';
    const BuildFailure failure =
        parseDiagnostics(link ? "link" : "warp.cpp", std::string(bytes),
                         {{"src/warp.cpp", "entrega/warp.cpp"}, {"include/nori/mesh.h", "mesh.h"}});
    require(failure.errors.size() <= 10, "a report has ten errors at most");
    require(failure.describe().size() < 4096, "a report is short");
}
