// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <catalog/warp_catalog.h>

#include <CLI/CLI.hpp>

#include <map>
#include <set>

namespace {

constexpr int kUsageError = 2;

constexpr char kFooter[] =
    R"(Without WARP a window opens; with one, or with --all, the tests run here. WARP is square, tent,
disk, triangle, sphere, hemisphere, cosine_hemisphere or beckmann; PARAM is Beckmann's alpha.

Examples:
  warptest                                   the window
  warptest beckmann 0.1                      the test of one warp
  warptest --all --against my/src/warp.cpp   your own warps, built and run in the sandbox
  warptest --all --evidence figures          the handout's pictures
  warptest --all --seeds 10 --html page.html everything there is to see, on one page
  warptest sphere --rows 51 --dump m >chitest.m   observed and expected counts
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

class Options {
public:
    Options(CLI::App &app, CommandLine &line) : m_app(app), m_line(line) {
        addSubject();
        addTest();
        addOutput();
        addWindow();
    }

    /// Refuses what would do nothing. \throws CLI::ParseError
    void check() {
        CommandLine &line = m_line;
        if (!line.warp.empty() && !line.mistakes) {
            const std::string unknown = CLI::IsMember(warpIds())(line.warp);
            if (!unknown.empty()) {
                throw CLI::ValidationError("WARP", unknown);
            }
        }
        if (line.settings.parameter > 0.0 && line.warp.empty()) {
            throw CLI::RequiresError("PARAM", "WARP");
        }
        if (line.all && !line.warp.empty()) {
            throw CLI::ExcludesError("--all", "WARP");
        }
        line.window = line.window || !line.screenshot.empty() || (line.warp.empty() && !line.all);
        need(m_textFile, !line.screenshot.empty(), "--screenshot");
        for (const CLI::Option *option : m_window->get_options()) {
            need(option, line.window, "--window");
        }
        for (const CLI::Option *option : {m_json, m_dump, m_html}) {
            need(option, !line.window, "WARP or --all, and no window");
        }
        need(m_all, !line.window, "no window, which has a key for it");
        need(m_rows,
             line.window || line.json || line.dump != DumpFormat::None || !line.html.empty() ||
                 !line.evidence.empty(),
             "--json, --dump, --html, --evidence or the window, where there are maps");
        need(m_points, line.window || !line.html.empty(),
             "--html or the window, where points are shown");
    }

private:
    static void need(const CLI::Option *option, bool met, const std::string &what) {
        if (option->count() > 0 && !met) {
            throw CLI::RequiresError(option->get_name(), what);
        }
    }

    void addSubject() {
        m_app.add_option("WARP", m_line.warp,
                         "What to test; with --mistakes any name of the window's list");
        m_app.add_option("PARAM", m_line.settings.parameter, "Its parameter")
            ->check(CLI::Range(viewer::kMinParameter, viewer::kMaxParameter));
        m_all = m_app.add_flag("--all", m_line.all,
                               "Test every warp, at all of its catalogue's parameters");
        m_app
            .add_option("--against", m_line.against,
                        "Whose warps: a hand-in (zip or folder) or one C++ file, built in the "
                        "sandbox on the student edition; default: this renderer's")
            ->type_name("SUBMISSION|FILE.cpp")
            ->check(CLI::ExistingPath);
        m_app.add_flag("--mistakes", m_line.mistakes, "Add known wrong warps to the list");
    }

    void addTest() {
        CLI::Option_group &test = *m_app.add_option_group("Test");
        viewer::Settings &settings = m_line.settings;
        test.add_option("--seed", settings.seed, "Of all random points [1]")->type_name("N");
        m_samples = test.add_option_function<std::size_t>(
            "--samples",
            [&settings](std::size_t count) {
                settings.samples = count;
                settings.count = count;
            },
            "Points of a test's first stage [1048576]; when it rejects, stages of 4 and 16 times "
            "as many confirm. Also the number of points that are shown [16384]");
        m_samples->type_name("N")->check(CLI::Range(std::size_t{1} << 10U, std::size_t{1} << 22U));
        test.add_option("--alpha", settings.significance,
                        "Level of the first two stages [1e-4]; the third has a tenth of it")
            ->type_name("P")
            ->check(CLI::Range(1e-12, 0.1));
        test.add_option("--seeds", settings.repeats,
                        "Whole tests with fresh random numbers; all must pass [1]")
            ->type_name("N")
            ->check(CLI::Range(1, 1000));
        m_rows = test.add_option("--rows", settings.rows, "And columns, of the maps [32]");
        m_rows->type_name("N")->check(CLI::Range(battery::kMinMapSide, battery::kMaxMapSide));
        m_points = test.add_option("--points", settings.points,
                                   "Which are shown: independent, grid, stratified or halton; the "
                                   "verdict always rests on independent and stratified ones");
        m_points->transform(CLI::CheckedTransformer(pointSets(), CLI::ignore_case))
            ->type_name("KIND");
    }

    void addOutput() {
        CLI::Option_group &output = *m_app.add_option_group("Output");
        m_json = output.add_flag("--json", m_line.json, "Print one JSON document instead of text");
        m_dump = output.add_option("--dump", m_line.dump,
                                   "Print the maps' counts instead of text: m (Matlab, Octave), "
                                   "csv or json");
        m_dump
            ->transform(CLI::CheckedTransformer(
                std::map<std::string, DumpFormat>{{"m", DumpFormat::Matlab},
                                                  {"csv", DumpFormat::Csv},
                                                  {"json", DumpFormat::Json}},
                CLI::ignore_case))
            ->type_name("m|csv|json")
            ->excludes(m_json);
        m_html = output.add_option("--html", m_line.html, "Write one page on all tests");
        m_html->type_name("FILE.html");
        output
            .add_option("--evidence", m_line.evidence,
                        "Write pictures and data of the tests here; for the window: where S saves")
            ->type_name("DIR");
    }

    void addWindow() {
        m_app.add_flag("--window", m_line.window, "Open the window also when a warp is named");
        m_app
            .add_option("--screenshot", m_line.screenshot, "Draw the window here; needs no display")
            ->type_name("FILE.png");
        m_textFile = m_app.add_option("--dump-ui", m_line.textFile,
                                      "With --screenshot: also the window's texts");
        m_textFile->type_name("FILE");
        m_window = m_app.add_option_group("Window");
        m_window->add_flag("--run", m_line.run, "Run its test at once");
        m_window->add_option("--ui-scale", m_line.scale, "Size of text and spaces, 0.75 to 2.5")
            ->type_name("X")
            ->check(CLI::Range(0.75, 2.5));
        m_window->add_option("--theme", m_line.theme, "dark, light or contrast")
            ->check(CLI::IsMember({"dark", "light", "contrast"}));
        m_window
            ->add_option("--view", m_line.tab, "Of the points: 1 space, 2 unit square, 3 domain")
            ->type_name("N")
            ->check(CLI::Range(1, 3));
    }

    CLI::App &m_app;
    CommandLine &m_line;
    CLI::Option *m_all = nullptr;
    CLI::Option *m_samples = nullptr;
    CLI::Option *m_rows = nullptr;
    CLI::Option *m_points = nullptr;
    CLI::Option *m_json = nullptr;
    CLI::Option *m_dump = nullptr;
    CLI::Option *m_html = nullptr;
    CLI::Option *m_textFile = nullptr;
    CLI::Option_group *m_window = nullptr;
};

/// As one would type it again.
std::string commandText(int argc, char **argv) {
    std::string text = "warptest";
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool isPlain = !word.empty() && word.find_first_of(" \t\n'\"\\$`*?[](){}<>|&;#~!") ==
                                                  std::string::npos;
        std::string quoted = "'";
        for (const char c : word) {
            quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        }
        text += ' ' + (isPlain ? word : quoted + "'");
    }
    return text;
}

} // namespace

std::optional<CommandLine> parseCommandLine(int argc, char **argv, int &exitCode) {
    CommandLine line;
    line.tab = 1;
    line.text = commandText(argc, argv);
    CLI::App app("Looks at a sampling warp and tells whether it is right.", "warptest");
    app.footer(kFooter);
    Options options(app, line);
    try {
        app.parse(argc, argv);
        options.check();
    } catch (const CLI::ParseError &error) {
        exitCode = app.exit(error) == 0 ? 0 : kUsageError;
        return std::nullopt;
    }
    return line;
}
