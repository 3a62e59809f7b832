// SPDX-License-Identifier: MIT
//
// An archive, down to the roles of its files.
#include <grader/submission/archive_reader.h>
#include <grader/submission/layout.h>
#include <grader/submission/names.h>
#include <grader/submission/nested.h>
#include <grader/submission/papers.h>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    using namespace grader;
    ReadLimits limits; // small, so that an execution is short
    limits.files = 50;
    limits.entries = 200;
    limits.fileBytes = 1U << 16U;
    limits.totalBytes = 1U << 18U;
    limits.ratioFrom = 1U << 16U;
    try {
        ReadBudget budget(limits, "archive");
        RawFiles raw = readArchiveBytes(bytes, "archive.zip", budget);
        openNestedArchives(raw, budget);
        for (const RawFile &file : raw.files) {
            require(isUtf8(file.path), "paths are UTF-8");
            require(file.bytes.size() <= limits.fileBytes, "no file is larger than the limit");
            require(!file.refused.empty() ||
                        pathFault(file.path).find("leaves") == std::string::npos,
                    "no path that leaves the archive is read");
        }
        Submission submission;
        sortFiles(raw.files, submission);
        checkPapers(submission);
        require(submission.files.size() == raw.files.size(), "every file is listed");
    } catch (const GraderError &) {
    }
}
