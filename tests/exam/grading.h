// SPDX-License-Identifier: MIT
#pragma once

#include "expectation.h"

namespace exam {

/// What the exam reads of one check of results.json.
struct GradedCheck {
    std::string id;
    std::string verdict;
    std::string severity;
    double score = 1;
    std::string message;
    std::vector<std::string> diagnoses; ///< ids, the likeliest first

    bool found() const; ///< whether it says that something is wrong
};

/// And of one item.
struct GradedItem {
    std::string id;
    double points = 0;
    double max = 0;
    std::string verdict;
    std::string reason;
    std::vector<std::string> diagnoses; ///< ids, the likeliest first
    std::vector<GradedCheck> checks;

    bool isFull() const;
    bool needsHuman() const; ///< its points are kept until a person has looked
};

struct GradedFigure {
    std::string path;
    std::string verdict; ///< with `!` before it if it is flagged
    std::string message;
};

struct Graded {
    double total = 0;
    std::vector<GradedItem> items;
    std::vector<GradedFigure> figures;
    double seconds = 0; ///< of wall clock
};

/// Of a round; fixed, so that a miss can be repeated.
std::string seedOf(int round);

/// Which tests a grading makes.
struct Question {
    std::string seed; ///< 32 hexadecimal digits
    std::string item; ///< empty: all
};

/// The grader could not test something, through no fault of the hand-in: another time it may.
class InfraError : public ExamError {
public:
    using ExamError::ExamError;
};

/// Grades one hand-in with the program itself.
/// \param jobs     processes that the program may use at the same time
/// \param scratch  an existing folder for its temporary files and its results
/// \return         results.json
/// \throws InfraError  if it could not test something
/// \throws ExamError   if it fails in any other way (a zero is no failure)
std::string gradeToJson(const std::filesystem::path &norigrade, const std::filesystem::path &handIn,
                        const Question &question, int jobs, const std::filesystem::path &scratch);

/// \throws ExamError  if it is not as published
Graded parseResults(const std::string &json);

/// Where a result is not what was expected, a sentence each; empty if all is well.
std::vector<std::string> compare(const Expectation &expectation, const Graded &graded);

/// Place of the planted mistake among the diagnoses of the items that lost points, from 1; 0 if it
/// is at none of them.
std::size_t diagnosisPlace(const Expectation &expectation, const Graded &graded);

/// `100, nothing lost`; `warp.disk lost, others full`.
std::string describe(const Expectation &expectation);

/// `100`, or the total and the items that lost points: `100: warp.disk 0/10`.
std::string describe(const Graded &graded);

} // namespace exam
