// SPDX-License-Identifier: MIT
#pragma once

#include "expectation.h"

namespace exam {

/// A text of a file that is replaced; it has to be there exactly once.
struct Change {
    std::string file; ///< relative to the hand-in
    std::string before, after;
};

/// A small change of a hand-in of tests/submissions: a mutant or a variant. The keys of its file
/// are explained in tests/mutants/README.md and tests/variants/README.md.
struct Patch {
    enum class Cost {
        Nothing, ///< a variant: right
        Visible, ///< the item loses points, by a visible check
        Latent,  ///< the item loses points, but no more than its latent fraction
        Blemish, ///< a remark, and no point
    };

    std::string name; ///< path below its folder, without `.toml`
    std::string base; ///< `accepted/reference`
    std::string what; ///< the mistake, or the difference, in one sentence
    Cost cost = Cost::Nothing;
    std::string item;                   ///< the one that it costs; empty for variants
    std::vector<std::string> diagnoses; ///< ids, one of which must be named; may be empty
    std::string equivalent;             ///< where the mistake makes no difference; may be empty
    std::vector<std::string> missing;   ///< items that are not done, and so not got

    std::vector<std::string> without; ///< files of the base that are not handed in
    std::vector<Change> changes;
    std::vector<Change> files; ///< new or replaced ones: `after` is all their text
    bool crlf = false;         ///< written with the line ends of Windows

    const char *costName() const;
};

/// All patches below `folder`, by name; those with `pattern` in their name, all if it is empty.
/// \throws ExamError  on a mistake in a file, with its line, or if there is none
std::vector<Patch> findPatches(const std::filesystem::path &folder, const std::string &pattern);

/// Writes the changed hand-in.
/// \param submissions  the folder of the bases
/// \param work         an empty folder
/// \return             the folder to grade
/// \throws ExamError   if a text that is to be changed is not there, or more than once
std::filesystem::path apply(const Patch &patch, const std::filesystem::path &submissions,
                            const std::filesystem::path &work);

} // namespace exam
