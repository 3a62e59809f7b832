// SPDX-License-Identifier: MIT
#include "view_command.h"

#include <fmt/core.h>

#include <unistd.h>

#include <filesystem>

#include <preview/image_summary.h>

namespace {

void print(const std::vector<std::string> &lines) {
    for (const std::string &line : lines)
        fmt::print("{}\n", line);
}

} // namespace

bool opensWindow(const CommandLine &line) {
    if (line.windowing != Windowing::IfPossible)
        return line.windowing == Windowing::Always;
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (isatty(descriptor) == 0)
            return false;
    }
    return preview::canShow();
}

int viewImage(const CommandLine &line) {
    const nori::Bitmap image(line.file);
    const nori::Bitmap reference =
        line.reference.empty() ? nori::Bitmap() : nori::Bitmap(line.reference);
    if (opensWindow(line)) {
        preview::ViewModel model(std::filesystem::path(line.file).filename().string(), nullptr);
        model.setImage(image);
        if (reference.size() > 0)
            model.setReference(reference, line.reference);
        model.setLook(line.look);
        preview::show(model, line.window);
        return 0;
    }
    fmt::print("{}: {} x {} pixels\n      {:>9} {:>9} {:>9}\n", line.file, image.cols(),
               image.rows(), "R", "G", "B");
    print(preview::describe(preview::summarize(image)));
    if (reference.size() == 0)
        return 0;
    const std::optional<preview::ImageError> error = preview::measureError(image, reference);
    if (!error)
        throw nori::NoriException("%s: has %d x %d pixels, so it cannot be compared in numbers",
                                  line.reference, reference.cols(), reference.rows());
    fmt::print("compared with {}\n", line.reference);
    print(preview::describe(*error));
    return 0;
}
