// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

namespace grader {

/// One error of the compiler or linker.
struct Diagnostic {
    std::string file; ///< as in the hand-in; empty for the linker
    int line = 0;
    int column = 0;
    std::string message;
};

/// Why a file (or a whole link) did not build.
struct BuildFailure {
    std::string unit;               ///< `scene.cpp`; `link` for the link
    std::vector<Diagnostic> errors; ///< the first ones, in the compiler's order
    std::string missing;            ///< the declaration or file that is not there; may be empty
    std::string probablyIn;         ///< the file that probably holds it; may be empty

    /// `scene.cpp does not compile: src/scene.cpp:31: 'm_pdf' was not declared …; it is probably in
    /// scene.h, which was not handed in`.
    std::string describe() const;
};

/// Reads the output of g++ or ld.
///
/// \param names  staged path (`src/warp.cpp`, `include/nori/mesh.h`) to the hand-in's own path
BuildFailure parseDiagnostics(const std::string &unit, const std::string &log,
                              const std::map<std::string, std::string> &names);

} // namespace grader
