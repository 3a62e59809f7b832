// SPDX-License-Identifier: MIT
#include "starter.h"

#include <grader/build/base.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <algorithm>

namespace grader {

namespace {

constexpr std::string_view kMarker = "// graded: ";
constexpr std::string_view kKept = "//# ";

/// Scenes that are not the handout's: they ask for what only our own emitters can.
constexpr std::string_view kOwnScenes[] = {"serapis_ems_power.xml", "serapis_env_map.xml"};

enum class Region { Outside, Graded, Replacement, Kept };

[[noreturn]] void misplaced(const std::string &file, int line, std::string_view marker) {
    throw GraderError(fmt::format("{}:{}: misplaced marker \"{}\"", file, line, marker));
}

/// \param message  of the region's marker: what is not yet implemented, or nothing
bool isKept(std::string_view message, const std::vector<std::string> &kept) {
    return !kept.empty() &&
           (message.empty() || std::any_of(kept.begin(), kept.end(), [&](const std::string &each) {
                return message.substr(0, each.size() + 1) == each + "(";
            }));
}

std::string_view messageOf(std::string_view marker) {
    return marker.size() > 6 ? marker.substr(6) : std::string_view();
}

/// \return  nothing where the marker is out of place
std::optional<Region> regionAfter(std::string_view marker, Region region,
                                  const std::vector<std::string> &kept) {
    if (marker.substr(0, 5) == "begin" && region == Region::Outside)
        return isKept(messageOf(marker), kept) ? Region::Kept : Region::Graded;
    if (marker == "else" && region == Region::Graded)
        return Region::Replacement;
    if (marker == "end" && region != Region::Outside)
        return Region::Outside;
    return std::nullopt;
}

} // namespace

std::optional<std::string> starterText(std::string_view text, const std::string &file,
                                       const std::vector<std::string> &kept) {
    std::string result;
    Region region = Region::Outside;
    int number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        const std::string_view line = text.substr(0, end + 1);
        text.remove_prefix(end + 1);
        ++number;

        const std::size_t indent = std::min(line.find_first_not_of(" \t"), line.size());
        std::string_view body = line.substr(indent);
        while (!body.empty() && (body.back() == '\n' || body.back() == '\r'))
            body.remove_suffix(1);
        if (body.substr(0, kMarker.size()) == kMarker) {
            const std::string_view marker = body.substr(kMarker.size());
            if (marker == "file" && region == Region::Outside)
                return std::nullopt;
            const std::optional<Region> after = regionAfter(marker, region, kept);
            if (!after)
                misplaced(file, number, body);
            region = *after;
            if (region == Region::Graded && !messageOf(marker).empty())
                result += fmt::format("{}throw NoriException(\"{}\");\n", line.substr(0, indent),
                                      messageOf(marker));
        } else if (region == Region::Outside || region == Region::Kept) {
            result += line;
        } else if (region == Region::Replacement) {
            if (body.substr(0, kKept.size()) != kKept)
                misplaced(file, number, body);
            result += fmt::format("{}{}\n", line.substr(0, indent), body.substr(kKept.size()));
        }
    }
    if (region != Region::Outside)
        throw GraderError(fmt::format("{}: a graded region has no end", file));
    return result;
}

void writeStarter(const std::filesystem::path &folder) {
    namespace fs = std::filesystem;
    if (fs::exists(folder) && !fs::is_empty(folder))
        throw GraderError(fmt::format("{}: is not empty; name a folder that does not exist yet",
                                      folder.string()));
    const Base &base = starterBase();
    for (const auto &[name, text] : base.headers) {
        const bool isNori = name.rfind("nori/", 0) == 0;
        const bool isOurs = name.rfind("probe/", 0) == 0 || name.rfind("protocol/", 0) == 0;
        if (!isOurs)
            writeTextFile(folder / (isNori ? "include" : "compat") / name, text);
    }
    std::string sources;
    for (const auto &[name, text] : base.units) {
        writeTextFile(folder / "src" / name, text);
        sources += fmt::format("    src/{}\n", name);
    }
    writeTextFile(folder / "sources.cmake",
                  fmt::format("# Add the files that you write, such as src/direct_ems.cpp.\n"
                              "set(NORI_SOURCES\n{})\n",
                              sources));
    const std::pair<const char *, const char *> folders[] = {
        {"renderer/starter", ""},
        {"renderer/app", "app"},
        {"renderer/window", "window"},
        {"scenes/assignment-2", "scenes/assignment-2"},
        {"scenes/meshes", "scenes/meshes"}};
    for (const auto &[from, to] : folders) {
        const fs::path source = projectFolder() / from;
        for (const auto &entry : fs::recursive_directory_iterator(source)) {
            const std::string name = entry.path().filename().string();
            const bool isOwn = std::find(std::begin(kOwnScenes), std::end(kOwnScenes), name) !=
                               std::end(kOwnScenes);
            if (entry.is_regular_file() && !isOwn)
                writeTextFile(folder / to / entry.path().lexically_relative(source),
                              readTextFile(entry.path()));
        }
    }
}

} // namespace grader
