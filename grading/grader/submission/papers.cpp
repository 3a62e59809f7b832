// SPDX-License-Identifier: MIT
#include <grader/submission/figure_name.h>
#include <grader/submission/members.h>
#include <grader/submission/names.h>
#include <grader/submission/papers.h>
#include <grader/submission/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace grader {

namespace {

constexpr std::size_t kReadmeBytes = 1U << 16U;

/// A figure that the handout asks for.
struct AskedFigure {
    const char *stem;
    bool anySamples; ///< `stem_SPP` with any number, else the stem alone
    bool exrToo;     ///< both an .exr and a .png
};

constexpr std::array<AskedFigure, 10> kAskedFigures{{
    {"UniformTriangle", false, false},
    {"UniformSphere", false, false},
    {"UniformHemisphere", false, false},
    {"CosineHemisphere", false, false},
    {"Beckmann", false, false},
    {"serapis_whitted_1", false, true},
    {"serapis_whitted_64", false, true},
    {"serapis_ems_1", false, true},
    {"serapis_ems_64", false, true},
    {"serapis_env", true, true},
}};

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

bool matches(const AskedFigure &asked, const std::string &stem) {
    const FigureName wanted = parseFigureName(asked.stem);
    const FigureName name = parseFigureName(stem);
    return name.scene == wanted.scene &&
           (asked.anySamples ? name.samples > 0 : name.samples == wanted.samples);
}

bool isThere(const Submission &submission, const AskedFigure &asked, std::string_view extension) {
    return std::any_of(submission.files.begin(), submission.files.end(),
                       [&](const SubmittedFile &file) {
                           const PathParts parts = splitPath(file.path);
                           return parts.extension == extension && matches(asked, parts.stem);
                       });
}

/// Web links of a text that lead to a shared folder.
std::vector<std::string> sharedFolders(std::string_view text) {
    static constexpr std::array<const char *, 10> kHosts{
        "drive.google", "docs.google", "onedrive",   "1drv.ms",   "sharepoint",
        "dropbox",      "mega.nz",     "wetransfer", "nextcloud", "unizar"};
    std::vector<std::string> links;
    for (std::size_t at = text.find("http"); at != std::string_view::npos;
         at = text.find("http", at + 4)) {
        const std::string_view rest = text.substr(at);
        const std::string_view link = rest.substr(0, rest.find_first_of(" \t\n\"'<>)]"));
        const std::string lower = lowerAscii(link);
        if (std::any_of(kHosts.begin(), kHosts.end(),
                        [&](const char *host) { return contains(lower, host); }) &&
            links.size() < 10) {
            links.push_back(shortened(link));
        }
    }
    return links;
}

void checkReadme(Submission &submission, const SubmittedFile &readme) {
    if (readme.bytes.find_first_not_of(" \t\n") == std::string::npos) {
        submission.notes.push_back({Note::Level::Odd, readme.path, "The README is empty."});
        return;
    }
    const std::vector<std::string> nips = findNips(readme.bytes, submission.members);
    std::vector<std::string> members = submission.members;
    std::sort(members.begin(), members.end());
    if (!nips.empty() && nips != members) {
        submission.notes.push_back(
            {Note::Level::Human, readme.path,
             fmt::format("The name of the hand-in says {}, its README says {}: whose is it?",
                         fmt::join(members, ", "), fmt::join(nips, ", "))});
    }
}

} // namespace

bool isReadmeName(std::string_view name) {
    static constexpr std::array<const char *, 8> kStems{"readme", "read_me", "read me", "read-me",
                                                        "leeme",  "léeme",   "leame",   "léame"};
    static constexpr std::array<const char *, 6> kEndings{"",     ".txt",      ".md",
                                                          ".rst", ".markdown", ".txt.txt"};
    const std::string folded = foldName(name);
    return std::any_of(kStems.begin(), kStems.end(), [&](const char *stem) {
        return std::any_of(kEndings.begin(), kEndings.end(), [&](const char *ending) {
            return folded == fmt::format("{}{}", stem, ending);
        });
    });
}

bool isFigureName(std::string_view name) {
    static constexpr std::array<const char *, 9> kExtensions{
        ".png", ".exr", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".gif", ".hdr"};
    const std::string extension = splitPath(name).extension;
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::vector<std::string> missingFigures(const Submission &submission) {
    std::vector<std::string> missing;
    for (const AskedFigure &asked : kAskedFigures) {
        const std::string name =
            fmt::format("{}{}", asked.stem, asked.anySamples ? "_<samples>" : "");
        if (asked.exrToo && !isThere(submission, asked, ".exr")) {
            missing.push_back(name + ".exr");
        }
        if (!isThere(submission, asked, ".png")) {
            missing.push_back(name + ".png");
        }
    }
    return missing;
}

std::string readmeText(std::string_view bytes) {
    bytes = bytes.substr(0, kReadmeBytes);
    std::string text = normalizeText(bytes).text;
    std::replace(text.begin(), text.end(), '\0', ' ');
    // A cut may have split the last character: that is not a sign of another charset.
    const std::size_t end = text.find_last_of('\n');
    const std::string_view whole = std::string_view(text).substr(0, end);
    return isUtf8(whole) ? text : toUtf8(text, "windows-1252");
}

void checkPapers(Submission &submission) {
    std::vector<std::string> links;
    const auto readme =
        std::find_if(submission.files.begin(), submission.files.end(),
                     [](const SubmittedFile &file) { return file.role == FileRole::Readme; });
    if (readme == submission.files.end()) {
        submission.notes.push_back(
            {Note::Level::Odd, "", "There is no README (README.txt with authors and references)."});
    } else {
        checkReadme(submission, *readme);
        links = sharedFolders(readme->bytes);
    }
    if (const auto missing = missingFigures(submission); !missing.empty()) {
        submission.notes.push_back(
            {Note::Level::Odd, "",
             fmt::format("Figures that the handout asks for and that are not here under its names: "
                         "{}.",
                         fmt::join(missing, ", "))});
    }
    if (!links.empty()) {
        submission.notes.push_back(
            {Note::Level::Info, readme->path,
             fmt::format("The README links to a shared folder, which was not opened: {}",
                         fmt::join(links, " "))});
    }
}

} // namespace grader
