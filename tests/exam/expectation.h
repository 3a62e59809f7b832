// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// The grader's own exam: whole hand-ins, each with the result that it must get.
namespace exam {

/// The exam itself cannot go on; says what and where.
class ExamError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

enum class Kept {
    Any,  ///< nothing is said about this item
    Full, ///< no point may be lost
    Lost, ///< some points, or all, must be lost
    Zero, ///< not one point may be given
};

/// How a hand-in is put together before it is graded.
struct Recipe {
    std::string base;                 ///< another case that it changes; empty: complete by itself
    std::vector<std::string> without; ///< paths of the base that were not handed in
    std::string zip;                  ///< name of the zip to pack it into; empty: a folder
    bool fromStarter = false;         ///< what `norigrade starter` writes
};

/// An expected.toml: which result a hand-in must get.
struct Expectation {
    Recipe recipe;
    double minTotal = 0, maxTotal = 100;
    Kept others = Kept::Any;                     ///< items that are not in `items`
    std::map<std::string, Kept> items;           ///< by item id
    std::map<std::string, std::string> verdicts; ///< by item id, as in results.json
    /// By path: verdict, as in results.json; with `!` before it if it must be flagged.
    std::map<std::string, std::string> figures;
    std::string diagnosis; ///< id that must come first at an item that loses points; may be empty
    bool hostile = false;  ///< graded alone; the machine is looked over afterwards
    std::vector<std::string> leftFiles; ///< names of files that it tries to leave behind
};

/// Reads an expected.toml; its keys are explained in tests/submissions/README.md.
/// \throws ExamError  with file and line on a syntax error, an unknown key or a wrong type
Expectation readExpectation(const std::filesystem::path &file);

} // namespace exam
