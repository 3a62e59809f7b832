// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/raw_files.h>

namespace grader {

/// Opens the archives that lie in a hand-in.
///
/// Where one part holds the sources (the hand-in itself, or a single archive in it), everything is
/// put together: `src.zip` beside `figures.zip`, a zip in a zip. Where several parts hold sources,
/// those of the hand-in itself are used, or none at all: choosing is for a person.
///
/// \throws LimitError  if a limit is passed
void openNestedArchives(RawFiles &read, ReadBudget &budget);

} // namespace grader
