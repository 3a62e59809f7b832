// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <nori/common.h>

#include <CLI/CLI.hpp>

#include <charconv>
#include <filesystem>
#include <map>
#include <vector>

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

On a terminal with a display the render is shown in a window: exposure, zoom and pixel values, and
what it differs in from a reference. That is --reference, or SCENE.exr in a folder `references`
here or above. The image is the same with or without a window, bit for bit, and is written as soon
as it is done. Closing the window does not end the render; it goes on in the terminal. No window
opens with -b, --quiet or --output, or when input or output are no terminal.

An .exr instead of a scene is shown, two are compared; without a window their numbers are printed.

Examples:
  nori scenes/assignment-2/cbox/cbox_ems.xml
  nori cbox_ems.xml --spp 64 --seed 7 --output /tmp/cbox
  nori -t 4 -b serapis_ems.xml
  nori mine.exr reference.exr --view difference
  nori cbox_ems.xml --screenshot window.png

Exit codes: 0 done, 1 error, 2 usage or no window can be opened, 130 interrupted.)";

void addWindowOptions(CLI::App &app, CommandLine &line, bool &with) {
    CLI::Option_group &window = *app.add_option_group("Window");
    window.add_flag("--window", with, "Open one whatever else is said");
    window.add_option("--reference", line.reference, "Image to compare with")
        ->type_name("FILE.exr");
    window.add_option("--view", line.look.view, "image, reference, split or difference")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, preview::View>{{"image", preview::View::Image},
                                                 {"reference", preview::View::Reference},
                                                 {"split", preview::View::Split},
                                                 {"difference", preview::View::Difference}},
            CLI::ignore_case))
        ->type_name("VIEW");
    window.add_option("--exposure", line.look.exposure, "Shows values times 2^EV")
        ->type_name("EV")
        ->check(CLI::Range(-20.0, 20.0));
    window.add_option("--ui-scale", line.window.scale, "Size of text and spaces, 0.75 to 2.5")
        ->type_name("X")
        ->check(CLI::Range(0.75, 2.5));
    window.add_option("--theme", line.window.theme, "dark, light or contrast")
        ->check(CLI::IsMember({"dark", "light", "contrast"}));
    window
        .add_option("--screenshot", line.window.screenshot,
                    "Draw the window here at the end; needs no display")
        ->type_name("FILE.png");
    window
        .add_option("--dump-ui", line.window.textFile, "With --screenshot: also the window's texts")
        ->type_name("FILE");
}

} // namespace

bool namesImage(const std::string &file) {
    return nori::toLower(std::filesystem::path(file).extension().string()) == ".exr";
}

std::optional<CommandLine> parseCommandLine(int argc, char **argv, int &exitCode) {
    CommandLine line;
    CLI::App app("Renders a Nori 2 scene, or shows images.", "nori");
    app.footer(kFooter);
    app.set_version_flag("--version", std::string("nori ") + kNoriVersion);
    std::vector<std::string> files;
    app.add_option("FILE", files, "Scene (.xml), or an image (.exr) and one to compare it with")
        ->required()
        ->expected(1, 2);
    app.add_option("--output", line.output, "Where to write, without suffix")
        ->type_name("STEM")
        ->check([](const std::string &stem) { return stem.empty() ? "is empty" : ""; });
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
    bool without = false;
    bool with = false;
    app.add_flag("-b,--nogui,--no-gui", without, "Open no window");
    addWindowOptions(app, line, with);
    try {
        app.parse(argc, argv);
        const bool isImage = namesImage(files[0]);
        if (files.size() > 1 && (!isImage || !line.reference.empty()))
            throw CLI::ValidationError(
                "FILE", isImage ? "one image to compare with is enough"
                                : "is one scene; an image to compare with is --reference");
        if (!line.window.textFile.empty() && line.window.screenshot.empty())
            throw CLI::RequiresError("--dump-ui", "--screenshot");
        if (files.size() > 1)
            line.reference = files[1];
        line.file = files[0];
        if (with || !line.window.screenshot.empty())
            line.windowing = Windowing::Always; // also against -b, which ./run gives
        else if (without || line.quiet || !line.output.empty())
            line.windowing = Windowing::Never;
    } catch (const CLI::ParseError &error) {
        exitCode = app.exit(error) == 0 ? 0 : kUsageError;
        return std::nullopt;
    }
    return line;
}
