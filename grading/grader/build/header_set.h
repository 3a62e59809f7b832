// SPDX-License-Identifier: MIT
#pragma once

#include <grader/build/base.h>

#include <set>
#include <string>

namespace grader {

/// The headers that the units of one variant are compiled with.
struct HeaderSet {
    Files files; ///< the base's, with the submission's laid over them
    /// Spellings that Linux would not find and what they mean: `nori/Warp.h`, `nori\mesh.h`, each a
    /// forwarding header.
    Files forwards;
};

/// Lays a submission's headers (plain name to text) over the base's: `emitter.h` replaces
/// `nori/emitter.h`, a new name becomes `nori/<name>`.
HeaderSet overlayHeaders(const Files &base, const Files &submitted);

/// Adds forwards for the includes of `text` that differ from a header's name only in case or in
/// backslashes.
/// \return  the spellings added
std::set<std::string> addForwards(const std::string &text, HeaderSet &headers);

/// Names of the headers that `text` can reach, through any number of includes and whatever the
/// preprocessor decides: what a compiled unit depends on.
std::set<std::string> includeClosure(const std::string &text, const HeaderSet &headers);

} // namespace grader
