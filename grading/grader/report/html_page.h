// SPDX-License-Identifier: MIT
#pragma once

#include <grader/diagnosis/catalogue.h>
#include <grader/results/results.h>

#include <string>

namespace grader {

/// One hand-in as a page of its own: everything that results.json says of it, readable without a
/// server, a network or scripts, in light and dark. Its content security policy allows nothing but
/// its own style sheet. Diagnoses and hints are in it in both languages, with a switch that needs
/// no script. \param language  that is shown first
std::string htmlPage(const SubmissionResult &result, const Provenance &provenance,
                     Language language = Language::English);

/// File name of a hand-in's page: ASCII, from its name, ending in `.html`.
/// \param index  how many hand-ins of the run before it had the same file name
std::string pageName(const std::string &submissionName, std::size_t index);

} // namespace grader
