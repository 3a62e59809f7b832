// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Hand-ins whose mistakes are known, to try a rubric on.
namespace grader {

/// A text of a file that a mutant or variant replaces; `before` has to be there exactly once.
struct TextChange {
    std::string file;
    std::string before;
    std::string after;
};

/// One hand-in of the corpus, and what a rubric must make of it. The formats are those of
/// tests/submissions, tests/mutants and tests/variants; keys for other programs are passed over.
struct CorpusCase {
    std::string name;                 ///< `submissions/wrong/disk_pdf_one`
    std::string what;                 ///< the mistake in a sentence; may be empty
    std::filesystem::path own;        ///< folder of its own files; empty: none
    std::filesystem::path base;       ///< folder of the hand-in that it changes; empty: none
    std::vector<std::string> without; ///< files of the base that are not in it
    std::vector<TextChange> changes;
    std::vector<std::pair<std::string, std::string>> files; ///< name and text of whole ones
    bool isStarter = false;        ///< nothing but what is handed out: gets nothing
    std::vector<std::string> lost; ///< items that must lose points
    std::vector<std::string> free; ///< items of which nothing is asked
    bool windowsLines = false;

    /// Whether nothing is wrong with it, or left out.
    bool isRight() const { return !isStarter && lost.empty() && free.empty(); }
};

/// Accepted, starter and wrong hand-ins, mutants and variants below `root`, by name. Hostile and
/// partial ones say nothing of a rubric and are left out, as are mutants that are only remarks.
/// \param only  part of the name; empty: all
/// \throws GraderError  if there is no `submissions` in `root`, or a file is not as it must be
std::vector<CorpusCase> readCorpus(const std::filesystem::path &root, const std::string &only);

/// Puts a hand-in together in the empty folder `to`.
/// \throws GraderError  if a file or a text to change is not there
void composeCase(const CorpusCase &which, const std::filesystem::path &to);

} // namespace grader
