// SPDX-License-Identifier: MIT
//
// Names of hand-ins and files, the README, and all text that is shown. The first line is a name.
#include <grader/results/safe_text.h>
#include <grader/submission/members.h>
#include <grader/submission/names.h>
#include <grader/submission/papers.h>
#include <grader/submission/text.h>

#include <algorithm>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    using namespace grader;
    const std::string_view name = bytes.substr(0, bytes.find('\n'));
    for (const std::string &decoded : decodeNames({std::string(name), std::string(bytes)})) {
        require(isUtf8(decoded), "names are UTF-8");
        foldName(decoded);
        require(isUtf8(shortened(decoded, 20)), "names are cut between characters");
        splitPath(decoded);
        isReadmeName(decoded);
        isFigureName(decoded);
    }
    pathFault(name);
    const NamedMembers named = parseMembers(name);
    const std::string readme = readmeText(bytes);
    const std::vector<std::string> nips = findNips(readme, named.members);
    require(std::is_sorted(nips.begin(), nips.end()), "NIPs are sorted");
    normalizeText(bytes);

    const std::string line = safeLine(bytes);
    require(isUtf8(line) && line.find_first_of("\n\r\t\x1b\x7f") == std::string::npos,
            "a safe line is one line of UTF-8 without controls");
    const std::string lines = safeLines(bytes);
    require(isUtf8(lines) && lines.find('\x1b') == std::string::npos,
            "safe lines are UTF-8 without escapes");
    escapeInvisible(lines);
}
