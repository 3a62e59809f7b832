// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <CLI/CLI.hpp>

#include <charconv>

#include "version.h"

namespace {

constexpr int kUsageError = 2;

/// `800x600`.
/// \return  the mistake; empty if there is none
std::string parseSize(const std::string &text, CommandLine &line) {
    const char *const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, line.width);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, line.height);
        if (height.ec == std::errc() && height.ptr == end && line.width > 0 && line.height > 0)
            return "";
    }
    return "is \"" + text + "\"; expected are width and height in pixels, such as 800x600";
}

constexpr char kFooter[] =
    R"(Writes SCENE_SPP.exr and SCENE_SPP.png beside the scene, or STEM.exr and STEM.png.
The header of the .exr says spp, seed, integrator, version, render and CPU time.
With --moments the .exr has more layers, per pixel and of the unfiltered samples: count.Y, and
mean.R/G/B, variance.R/G/B and third.R/G/B (third central moment).

Ctrl-C stops and writes what is there, marked `partial` in the header; twice stops at once.

Examples:
  nori scenes/assignment-2/cbox/cbox_ems.xml
  nori cbox_ems.xml --spp 64 --seed 7 --output /tmp/cbox
  nori -t 4 -b serapis_ems.xml

Exit codes: 0 done, 1 error, 2 usage, 130 interrupted.)";

} // namespace

std::optional<CommandLine> parseCommandLine(int argc, char **argv, int &exitCode) {
    CommandLine line;
    CLI::App app("Renders a Nori 2 scene.", "nori");
    app.footer(kFooter);
    app.set_version_flag("--version", std::string("nori ") + kNoriVersion);
    app.add_option("SCENE", line.scene, "Scene file (.xml)")->required();
    app.add_option("--output", line.output, "Where to write, without suffix")->type_name("STEM");
    app.add_option("--spp", line.samplesPerPixel, "Samples per pixel, instead of the scene's")
        ->type_name("N")
        ->check(CLI::Range(1, 1 << 24));
    app.add_option_function<std::string>(
           "--size",
           [&line](const std::string &text) {
               const std::string mistake = parseSize(text, line);
               if (!mistake.empty())
                   throw CLI::ValidationError("--size", mistake);
           },
           "Size of the image, instead of the scene's")
        ->type_name("WxH");
    app.add_option("--integrator", line.integrator, "Integrator, instead of the scene's")
        ->type_name("TYPE");
    app.add_option("--seed", line.seed, "Seed; different seeds give unrelated noise")
        ->type_name("N");
    app.add_option("-t,--threads", line.threads, "Threads; the image does not depend on it")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    app.add_flag("--moments", line.moments, "Also write the samples' moments per pixel");
    app.add_flag("--quiet", line.quiet, "Print nothing but errors and warnings");
    bool withoutWindow = false;
    app.add_flag("-b,--nogui,--no-gui", withoutWindow,
                 "Without a window: always so, and accepted for scripts that ask for it");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        exitCode = app.exit(error) == 0 ? 0 : kUsageError;
        return std::nullopt;
    }
    return line;
}
