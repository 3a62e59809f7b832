// SPDX-License-Identifier: MIT
#include "figure_check.h"

#include <grader/build/variant_builder.h>
#include <grader/digest.h>
#include <grader/error.h>
#include <grader/figures/figure_judge.h>
#include <grader/figures/film_patches.h>
#include <grader/submission/figure_name.h>
#include <grader/submission/names.h>
#include <grader/submission/papers.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace grader {

namespace {

using protocol::Image;

/// Compared figures of one hand-in; the handout asks for a handful.
constexpr std::size_t kMostFigures = 40;
constexpr const char *kNames[] = {"R", "G", "B"};

/// The files of one name: the EXR and what shows it.
using Pair = std::vector<const SubmittedFile *>;

/// Samples per pixel in the header of an EXR that nori wrote; 0: it does not say.
int samplesInHeader(const Image &image) {
    const auto found = image.attributes.find("spp");
    int samples = 0;
    if (found != image.attributes.end())
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), samples);
    return std::max(0, samples);
}

bool hasColor(const Image &image) {
    return std::all_of(std::begin(kNames), std::end(kNames),
                       [&](const char *name) { return image.channel(name) != nullptr; });
}

/// Whether a PNG is what an EXR looks like, but for rounding and a few pixels.
bool isShownBy(const Image &exr, const Image &png) {
    constexpr double kLevels = 2;
    constexpr double kPixels = 0.005;
    if (exr.width != png.width || exr.height != png.height)
        return false;
    std::size_t off = 0;
    std::size_t all = 0;
    for (const char *name : kNames) {
        const std::vector<float> &a = exr.channel(name)->values;
        const std::vector<float> &b = png.channel(name)->values;
        all += a.size();
        for (std::size_t i = 0; i < a.size(); ++i)
            off += std::abs(pngLevel(a[i]) - pngLevel(b[i])) > kLevels ? 1 : 0;
    }
    return static_cast<double>(off) <= kPixels * static_cast<double>(all);
}

std::string digestOf(const Image &image) {
    std::string bytes = fmt::format("{} {}", image.width, image.height);
    for (const char *name : kNames) {
        const std::vector<float> &values = image.channel(name)->values;
        bytes.append(reinterpret_cast<const char *>(values.data()), // NOLINT: to be digested
                     values.size() * sizeof(float));
    }
    return sha256Hex(bytes);
}

std::size_t countNonFinite(const Image &image) {
    std::size_t count = 0;
    for (const char *name : kNames) {
        const std::vector<float> &values = image.channel(name)->values;
        count += static_cast<std::size_t>(
            std::count_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); }));
    }
    return count;
}

/// Not black where a value is no number: it would spoil every mean.
void setNonFiniteToZero(Image &image) {
    for (protocol::Channel &channel : image.channels) {
        for (float &value : channel.values)
            value = std::isfinite(value) ? value : 0.0F;
    }
}

/// A result with what holds the same pixels as it.
struct Compared {
    FigureResult result;
    std::string digest; ///< empty: not decoded
};

class Checker {
public:
    explicit Checker(const FigureCheck &check) : m_check(check) {}

    /// Compares the files of one name.
    std::vector<Compared> comparePair(const Pair &files, bool isOneTooMany) const {
        std::vector<Compared> all;
        std::optional<Image> exr;
        FigureResult ofExr;
        for (const SubmittedFile *file : files) {
            Compared compared;
            FigureResult &result = compared.result;
            result.path = file->path;
            const std::optional<Image> image = decode(*file, result);
            if (image) {
                compared.digest = digestOf(*image);
                if (isOneTooMany) {
                    result.message = fmt::format("Only {} figures are compared.", kMostFigures);
                } else if (exr && image->format == "png" && isShownBy(*exr, *image)) {
                    const std::string path = result.path;
                    result = ofExr;
                    result.path = path;
                    result.message = "It shows the EXR file of its name.";
                    // What is wrong with the picture is told there; its PNG may not be at fault.
                    result.flag = false;
                } else {
                    compare(*file, *image, result);
                    if (exr) {
                        result.flag = true;
                        result.message =
                            "It does not show the EXR file of its name. " + result.message;
                    }
                }
                if (image->format == "exr") {
                    exr = image;
                    ofExr = result;
                }
            }
            all.push_back(std::move(compared));
        }
        return all;
    }

private:
    /// \return  nothing if it is not readable, or none of ours: `result` says so
    std::optional<Image> decode(const SubmittedFile &file, FigureResult &result) const {
        const std::string extension = splitPath(file.path).extension;
        if (extension != ".exr" && extension != ".png") {
            result.message = "Only EXR and PNG files are compared.";
            return std::nullopt;
        }
        ImageReading reading = m_check.decode(file.bytes);
        if (const auto *none = std::get_if<NoImage>(&reading)) {
            result.verdict = FigureVerdict::Unreadable;
            result.flag = true;
            result.message = "It cannot be decoded: " + none->message + ".";
            return std::nullopt;
        }
        Image image = std::get<Image>(std::move(reading));
        if (!hasColor(image)) {
            result.verdict = FigureVerdict::Unreadable;
            result.flag = true;
            result.message = "It has no channels R, G and B.";
            return std::nullopt;
        }
        return image;
    }

    void compare(const SubmittedFile &file, const Image &original, FigureResult &result) const {
        const FigureName name = parseFigureName(splitPath(file.path).stem);
        const FigureScenes::Found scene = m_check.scenes.find(name.scene);
        if (scene.fit == FigureScenes::Fit::None) {
            result.message = "No scene has its name.";
            return;
        }
        Image image = original;
        const std::size_t nonFinite = countNonFinite(image);
        setNonFiniteToZero(image);
        const int inHeader = samplesInHeader(image);
        const int samples = name.samples > 0 ? name.samples : inHeader;
        const std::string path = result.path;
        result = judgeFigure({image, scene, samples}, m_check, m_check.seed + "|" + path);
        result.path = path;
        result.scene = scene.scene;
        result.samples = samples;
        if (scene.fit == FigureScenes::Fit::Near || !name.asAsked)
            result.message += fmt::format(" (The name was taken for {}{}.)", scene.scene,
                                          samples > 0 ? fmt::format("_{}", samples) : "");
        if (scene.fit == FigureScenes::Fit::Variant)
            result.message +=
                fmt::format(" (A variant of {} by its name: only means are judged.)", scene.scene);
        if (samples == 0)
            result.message += " (Neither its name nor its header says how many samples it has.)";
        if (inHeader > 0 && name.samples > 0 && inHeader != name.samples) {
            result.flag = true;
            result.message += fmt::format(" Its header says {} samples per pixel.", inHeader);
        }
        if (nonFinite > 0) {
            result.flag = true;
            result.message += fmt::format(" {} of its values are not finite.", nonFinite);
        }
    }

    const FigureCheck &m_check;
};

/// The figures by folder and stem, EXR files first.
std::vector<Pair> pairsOf(const Submission &submission) {
    std::map<std::string, Pair> pairs;
    for (const SubmittedFile &file : submission.files) {
        if (file.role != FileRole::Figure)
            continue;
        const std::size_t dot = file.path.rfind('.');
        pairs[lowerAscii(file.path.substr(0, dot))].push_back(&file);
    }
    std::vector<Pair> all;
    for (auto &[stem, files] : pairs) {
        std::sort(files.begin(), files.end(), [](const auto *a, const auto *b) {
            const auto key = [](const SubmittedFile &file) {
                return std::pair(splitPath(file.path).extension, file.path);
            };
            return key(*a) < key(*b);
        });
        all.push_back(std::move(files));
    }
    return all;
}

/// Flags figures of different names that hold the same pixels.
void findCopies(std::vector<Compared> &figures) {
    std::map<std::string, const Compared *> first;
    for (Compared &figure : figures) {
        if (figure.digest.empty())
            continue;
        const auto [found, isNew] = first.emplace(figure.digest, &figure);
        const auto nameOf = [](const Compared &one) {
            const FigureName name = parseFigureName(splitPath(one.result.path).stem);
            return std::pair(name.scene, name.samples);
        };
        if (isNew || nameOf(*found->second) == nameOf(figure))
            continue;
        figure.result.flag = true;
        figure.result.message += fmt::format(" It holds the same pixels as {}.",
                                             splitPath(found->second->result.path).name);
    }
}

} // namespace

std::vector<FigureResult> checkFigures(const Submission &submission, const FigureCheck &check) {
    const std::vector<Pair> pairs = pairsOf(submission);
    std::vector<std::vector<Compared>> compared(pairs.size());
    // Code that does not end costs a few time limits, not some for each figure.
    constexpr int kGivenUp = 4;
    std::atomic<int> timeouts{0};
    std::atomic<bool> isAlive{false};
    FigureCheck bounded = check;
    bounded.ask = [&](const protocol::RequestGroup &group) {
        ProbeAnswer answer;
        answer.outcome.end = BoxTimedOut{true};
        answer.responses.resize(group.requests.size()); // pending
        if (!isAlive && timeouts >= kGivenUp)
            return answer;
        answer = check.ask(group);
        if (std::holds_alternative<BoxTimedOut>(answer.outcome.end))
            ++timeouts;
        else
            isAlive = true;
        return answer;
    };
    const Checker checker(bounded);
    std::atomic<std::size_t> done{0};
    parallelFor(pairs.size(), check.jobs, [&](std::size_t i) {
        compared[i] = checker.comparePair(pairs[i], i >= kMostFigures);
        check.progress(static_cast<double>(++done) / static_cast<double>(pairs.size()));
    });

    std::vector<Compared> flat;
    for (std::vector<Compared> &some : compared)
        std::move(some.begin(), some.end(), std::back_inserter(flat));
    findCopies(flat);
    const std::vector<std::string> missing = missingFigures(submission);
    std::vector<FigureResult> results;
    results.reserve(flat.size() + missing.size());
    for (Compared &one : flat)
        results.push_back(std::move(one.result));
    for (const std::string &name : missing) {
        FigureResult &result = results.emplace_back();
        result.path = name;
        result.verdict = FigureVerdict::Missing;
        result.message = "The handout asks for it.";
    }
    return results;
}

} // namespace grader
