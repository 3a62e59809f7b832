// SPDX-License-Identifier: MIT
#include "diagnostics.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace grader {

namespace {

constexpr std::size_t kMaxErrors = 10;
constexpr std::size_t kMaxLine = 600; // std::regex recurses: a longer line is not matched

/// What an error message says is missing. Group `what` of `pattern` is its name; group `owner`, if
/// not 0, is the class that should have it, else the class of the function around it is taken.
struct MissingPattern {
    const char *pattern;
    int what;
    int owner;
};

// g++ quotes with ' in the C locale, which the box sets.
constexpr MissingPattern kMissingPatterns[] = {
    {R"(fatal error: ([^:]+): No such file)", 1, 1},
    {R"('[^']*(?:class|struct) nori::(\w+)' has no member named '(\w+)')", 2, 1},
    {R"('class nori::(\w+)' has no member named '(\w+)')", 2, 1},
    {R"(no declaration matches '[^']*nori::(\w+)::(\w+)\()", 2, 1},
    {R"(no '[^']*nori::(\w+)::(\w+)\([^']*' member function declared)", 2, 1},
    {R"('(\w+)' is not a member of 'nori::(\w+)')", 1, 2},
    {R"('(\w+)' was not declared in this scope)", 1, 0},
    {R"('(\w+)' does not name a type)", 1, 0},
    {R"(invalid new-expression of abstract class type 'nori::(\w+)')", 1, 1},
    {R"(undefined reference to `nori::(\w+)::(\w+)\()", 2, 1},
    {R"(undefined reference to `([^']+)')", 1, 0},
};

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The file that Nori keeps a class in.
std::string fileOf(const std::string &owner, bool linking) {
    static const std::map<std::string, std::string> kStems = {{"AreaEmitter", "area"},
                                                              {"EnvironmentEmitter", "environment"},
                                                              {"PointEmitter", "pointlight"},
                                                              {"DiscretePDF", "dpdf"},
                                                              {"EmitterQueryRecord", "emitter"}};
    if (owner.find('.') != std::string::npos)
        return owner.substr(owner.find_last_of("/\\") + 1);
    const auto known = kStems.find(owner);
    const std::string stem = known != kStems.end() ? known->second : lower(owner);
    const bool inSource = linking || owner == "AreaEmitter" || owner == "EnvironmentEmitter" ||
                          owner == "PointEmitter";
    return stem + (inSource ? ".cpp" : ".h");
}

void findMissing(const std::string &message, const std::string &enclosing, BuildFailure &failure) {
    // Made once: an expression takes longer to make than to search for.
    static const std::vector<std::regex> kExpressions = [] {
        std::vector<std::regex> expressions;
        for (const MissingPattern &row : kMissingPatterns)
            expressions.emplace_back(row.pattern);
        return expressions;
    }();
    for (std::size_t i = 0; i < kExpressions.size(); ++i) {
        const MissingPattern &row = kMissingPatterns[i];
        std::smatch match;
        if (!std::regex_search(message, match, kExpressions[i]))
            continue;
        const bool linking = failure.unit == "link";
        failure.missing = match[row.what];
        const std::string owner = row.owner != 0 ? match[row.owner].str() : enclosing;
        if (!owner.empty())
            failure.probablyIn = fileOf(owner, linking);
        return;
    }
}

} // namespace

std::string BuildFailure::describe() const {
    std::string text = unit == "link" ? "The parts do not link" : unit + " does not compile";
    if (!errors.empty()) {
        const Diagnostic &first = errors.front();
        text += first.file.empty()
                    ? fmt::format(": {}", first.message)
                    : fmt::format(": {}:{}: {}", first.file, first.line, first.message);
    }
    if (missing.find('.') != std::string::npos)
        text += fmt::format(" (\"{}\" is not among the files)", missing);
    else if (!missing.empty() && !probablyIn.empty())
        text +=
            fmt::format(" (\"{}\" is missing; it is probably declared in {})", missing, probablyIn);
    else if (!missing.empty())
        text += fmt::format(" (\"{}\" is missing)", missing);
    return text;
}

BuildFailure parseDiagnostics(const std::string &unit, const std::string &log,
                              const std::map<std::string, std::string> &names) {
    static const std::regex kError(R"(^([^:\s][^:]*):(\d+):(\d+): (?:fatal )?error: (.*)$)");
    static const std::regex kInside(
        R"(In (?:copy |move )?(?:static )?(?:member function|constructor|destructor).*nori::(\w+)::)");
    static const std::regex kLinker(R"((undefined reference to .*|multiple definition of .*))");

    BuildFailure failure;
    failure.unit = unit;
    std::string enclosing;
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        if (line.size() > kMaxLine)
            line.resize(kMaxLine);
        std::smatch match;
        if (std::regex_search(line, match, kInside))
            enclosing = match[1];
        else if (line.find("At global scope:") != std::string::npos)
            enclosing.clear();
        Diagnostic diagnostic;
        if (std::regex_match(line, match, kError)) {
            const auto known = names.find(match[1]);
            diagnostic = {known != names.end() ? known->second : match[1].str(),
                          std::atoi(match[2].str().c_str()), std::atoi(match[3].str().c_str()),
                          match[4]};
        } else if (unit == "link" && std::regex_search(line, match, kLinker)) {
            diagnostic.message = match[1];
        } else {
            continue;
        }
        if (failure.missing.empty())
            findMissing(line, enclosing, failure);
        if (failure.errors.size() < kMaxErrors)
            failure.errors.push_back(diagnostic);
    }
    return failure;
}

} // namespace grader
