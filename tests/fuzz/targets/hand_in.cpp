// SPDX-License-Identifier: MIT
//
// The files of a hand-in, as an archive or a folder gives them: names, roles, includes. The input
// is `path` LF `bytes` for each, with a NUL between two.
#include <grader/build/header_set.h>
#include <grader/build/starter.h>
#include <grader/error.h>
#include <grader/submission/clutter.h>
#include <grader/submission/layout.h>
#include <grader/submission/papers.h>
#include <grader/submission/source_scan.h>
#include <grader/submission/text.h>

#include <algorithm>

#include "../target.h"

namespace {

grader::RawFiles filesOf(std::string_view bytes) {
    grader::RawFiles raw;
    while (!bytes.empty() && raw.files.size() < 50) {
        const std::string_view one = bytes.substr(0, bytes.find('\0'));
        bytes.remove_prefix(std::min(one.size() + 1, bytes.size()));
        const std::size_t end = std::min(one.find('\n'), one.size());
        raw.files.push_back({std::string(one.substr(0, end)),
                             std::string(one.substr(std::min(end + 1, one.size()))), ""});
    }
    return raw;
}

} // namespace

void fuzz::run(std::string_view bytes) {
    using namespace grader;
    RawFiles raw = filesOf(bytes);
    finishFiles(raw, LeftOutFolders());
    Submission submission;
    sortFiles(raw.files, submission);
    checkPapers(submission);
    require(submission.files.size() == raw.files.size(), "every file is listed");

    HeaderSet headers;
    headers.files = {{"nori/warp.h", "#include <nori/common.h>\n"}, {"nori/common.h", ""}};
    Files submitted;
    for (const SubmittedFile &file : submission.files) {
        if (file.role == FileRole::Header)
            submitted[file.name] = file.bytes;
    }
    headers = overlayHeaders(headers.files, submitted);
    for (const RawFile &file : raw.files) {
        const std::string text = normalizeText(file.bytes).text;
        scanSource(text);
        addForwards(text, headers);
        for (const std::string &name : includeClosure(text, headers))
            require(headers.files.count(name) == 1, "a unit depends on headers that are there");
        for (const auto &[spelling, name] : headers.forwards)
            require(spelling.find("..") == std::string::npos && spelling.front() != '/',
                    "a forwarding header stays in its folder");
        try {
            starterText(text, "file");
        } catch (const GraderError &) { // a marker out of place
        }
    }
}
