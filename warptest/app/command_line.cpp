// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <catalog/warp_catalog.h>

#include <CLI/CLI.hpp>

#include <map>
#include <set>

namespace {

constexpr int kUsageError = 2;

constexpr char kFooter[] =
    R"(Without WARP a window opens; with one, the test runs here. WARP is square, tent, disk, triangle,
sphere, hemisphere, cosine_hemisphere or beckmann; PARAM is Beckmann's alpha.

Examples:
  warptest                                   the window
  warptest beckmann 0.1                      the test of one warp
  warptest --all --evidence figures          the handout's pictures
  warptest triangle --window                 the window with this warp
  warptest sphere --run --screenshot a.png   a picture of the window, without a display

Exit codes: 0 pass, 1 fail or error, 2 usage or no display, 3 cannot tell.)";

std::set<std::string> warpIds() {
    std::set<std::string> ids;
    for (const catalog::WarpEntry &warp : catalog::warpCatalog()) {
        ids.emplace(warp.id);
    }
    return ids;
}

std::map<std::string, viewer::PointSet> pointSets() {
    std::map<std::string, viewer::PointSet> sets;
    for (std::size_t i = 0; i < viewer::kPointSetNames.size(); ++i) {
        sets[viewer::kPointSetNames.at(i)] = static_cast<viewer::PointSet>(i);
    }
    return sets;
}

void addOptions(CLI::App &app, CommandLine &line) {
    app.add_option("WARP", line.warp,
                   "What to test; with --mistakes any name of the window's list");
    app.add_option("PARAM", line.settings.parameter, "Its parameter")
        ->check(CLI::Range(viewer::kMinParameter, viewer::kMaxParameter));
    app.add_flag("--all", line.all, "Test every warp, at all of its catalogue's parameters");
    app.add_option("--seed", line.settings.seed, "Of all random points")->type_name("N");
    app.add_flag("--json", line.json, "Print one JSON document instead of text");
    app.add_option("--evidence", line.evidence,
                   "Write pictures and data of the tests here; for the window: where S saves")
        ->type_name("DIR");

    CLI::Option_group &window = *app.add_option_group("Window");
    window.add_flag("--window", line.window, "Open the window also when a warp is named");
    window.add_flag("--run", line.run, "Run its test at once");
    window.add_option("--points", line.settings.points, "independent, grid, stratified or halton")
        ->transform(CLI::CheckedTransformer(pointSets(), CLI::ignore_case))
        ->type_name("KIND");
    window.add_option("--samples", line.settings.count, "Number of points that are shown")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{32}, std::size_t{1} << 22U));
    window.add_flag("--mistakes", line.mistakes, "Add known wrong warps to the list");
    window.add_option("--ui-scale", line.scale, "Size of text and spaces, 0.75 to 2.5")
        ->type_name("X")
        ->check(CLI::Range(0.75, 2.5));
    window.add_option("--theme", line.theme, "dark, light or contrast")
        ->check(CLI::IsMember({"dark", "light", "contrast"}));
    window.add_option("--view", line.tab, "Of the points: 1 space, 2 unit square, 3 domain")
        ->type_name("N")
        ->check(CLI::Range(1, 3));
    window.add_option("--screenshot", line.screenshot, "Draw the window here; needs no display")
        ->type_name("FILE.png");
    window.add_option("--dump-ui", line.textFile, "With --screenshot: also the window's texts")
        ->type_name("FILE");
}

} // namespace

std::optional<CommandLine> parseCommandLine(int argc, char **argv, int &exitCode) {
    CommandLine line;
    line.tab = 1;
    CLI::App app("Looks at a sampling warp and tells whether it is right.", "warptest");
    app.footer(kFooter);
    addOptions(app, line);
    try {
        app.parse(argc, argv);
        if (!line.textFile.empty() && line.screenshot.empty()) {
            throw CLI::RequiresError("--dump-ui", "--screenshot");
        }
        if (!line.warp.empty() && !line.mistakes) {
            const std::string unknown = CLI::IsMember(warpIds())(line.warp);
            if (!unknown.empty()) {
                throw CLI::ValidationError("WARP", unknown);
            }
        }
        if (line.settings.parameter > 0.0 && line.warp.empty()) {
            throw CLI::RequiresError("PARAM", "WARP");
        }
    } catch (const CLI::ParseError &error) {
        exitCode = app.exit(error) == 0 ? 0 : kUsageError;
        return std::nullopt;
    }
    line.window = line.window || !line.screenshot.empty() || (line.warp.empty() && !line.all);
    return line;
}
