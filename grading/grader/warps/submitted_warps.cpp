// SPDX-License-Identifier: MIT
#include "submitted_warps.h"

#include <grader/build/variant_builder.h>
#include <grader/checks/warp_samples.h>
#include <grader/error.h>
#include <grader/prober/prober.h>
#include <grader/submission/layout.h>
#include <grader/submission/submission.h>
#include <grader/text_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

namespace grader {

namespace {

constexpr char kWarpUnit[] = "warp.cpp";

/// Points in one process: 16 MiB of questions, a quarter of a second of a right warp.
constexpr std::size_t kPointsAtOnce = std::size_t{1} << 21U;
constexpr BoxLimits kLimits = {.cpu = std::chrono::seconds(20),
                               .wall = std::chrono::seconds(90),
                               .memoryBytes = std::uint64_t{3} << 30,
                               .fileBytes = std::uint64_t{64} << 20,
                               .logBytes = std::uint64_t{1} << 20,
                               .processes = 32};

bool isSource(const std::filesystem::path &path) {
    static constexpr std::array<const char *, 4> kSuffixes{".cpp", ".cc", ".cxx", ".c++"};
    return std::find(kSuffixes.begin(), kSuffixes.end(), path.extension().string()) !=
           kSuffixes.end();
}

/// One file as a hand-in, under its own name in messages.
Submission submissionOf(const std::filesystem::path &path) {
    if (std::filesystem::is_directory(path) || !isSource(path))
        return readSubmission(path);
    Submission submission;
    submission.name = path.filename().string();
    sortFiles({{kWarpUnit, readTextFile(path), {}}}, submission);
    for (SubmittedFile &file : submission.files)
        file.path = submission.name;
    return submission;
}

/// As compilers write it, so that editors find the place.
std::string explain(const BuildFailure &failure) {
    std::string text = fmt::format("{} does not {}", failure.unit == "link" ? "it" : failure.unit,
                                   failure.unit == "link" ? "link:" : "compile:");
    for (const Diagnostic &error : failure.errors)
        text += error.file.empty() ? fmt::format("\n{}", error.message)
                                   : fmt::format("\n{}:{}:{}: error: {}", error.file, error.line,
                                                 error.column, error.message);
    if (failure.errors.empty())
        text = failure.describe();
    return text;
}

class BoxedProbe : public ProbeClient {
public:
    BoxedProbe(const Sandbox &sandbox, std::filesystem::path executable)
        : m_sandbox(sandbox), m_executable(std::move(executable)) {}

    ProbeAnswer ask(const protocol::RequestGroup &group) override {
        return askProbe(m_sandbox, m_executable, group, kLimits);
    }

private:
    const Sandbox &m_sandbox;
    std::filesystem::path m_executable;
};

[[noreturn]] void raise(const CheckResult &failure) {
    if (failure.verdict == Verdict::Missing)
        throw battery::NotImplemented(failure.message);
    throw std::runtime_error(failure.message);
}

/// Calls `ask` on parts of `all` that one process can answer, and joins what it returns.
template <typename In, typename Ask>
auto askInParts(std::span<const In> all, Ask ask) {
    decltype(ask(std::vector<In>())) joined;
    joined.reserve(all.size());
    for (std::size_t at = 0; at < all.size(); at += kPointsAtOnce) {
        const auto part = all.subspan(at, std::min(kPointsAtOnce, all.size() - at));
        const auto answers = ask(std::vector<In>(part.begin(), part.end()));
        joined.insert(joined.end(), answers.begin(), answers.end());
    }
    return joined;
}

} // namespace

struct SubmittedWarps::Parts {
    Sandbox sandbox;
    Cache cache;
    std::string name;
    std::vector<std::string> notes;
    std::filesystem::path executable;
};

SubmittedWarps::SubmittedWarps(const std::filesystem::path &path, int jobs,
                               const std::function<void(double fraction)> &progress)
    : m_parts(std::make_unique<Parts>()) {
    if (!std::filesystem::exists(path))
        throw GraderError(fmt::format("{}: no such file or folder", path.string()));
    const Submission submission = submissionOf(path);
    if (submission.find(FileRole::Source, kWarpUnit) == nullptr)
        throw GraderError(
            fmt::format("{}: there is no {} in it; give a hand-in, or the file itself",
                        path.string(), kWarpUnit));
    m_parts->name = submission.name;
    Compiler compiler(m_parts->sandbox, m_parts->cache);
    VariantBuilder builder(compiler, submission, jobs);
    if (const std::optional<BuildFailure> failure = builder.failureOf(kWarpUnit))
        throw GraderError(explain(*failure));
    builder.compileAll(progress);
    const Variant variant = builder.build({"student", {{kWarpUnit, Origin::Student}}});
    if (!variant.executable)
        throw GraderError(variant.failures.empty() ? path.string() + ": cannot be linked"
                                                   : explain(variant.failures.back()));
    m_parts->executable = *variant.executable;
    for (const Note &note : builder.notes())
        m_parts->notes.push_back(note.file.empty() ? note.text : note.file + ": " + note.text);
}

SubmittedWarps::~SubmittedWarps() = default;

const std::string &SubmittedWarps::name() const {
    return m_parts->name;
}

const std::vector<std::string> &SubmittedWarps::notes() const {
    return m_parts->notes;
}

std::vector<battery::Output> SubmittedWarps::warp(const catalog::WarpEntry &entry,
                                                  std::span<const battery::Input> inputs,
                                                  double a) const {
    BoxedProbe probe(m_parts->sandbox, m_parts->executable);
    return askInParts(inputs, [&](std::vector<battery::Input> part) {
        WarpAnswer answer = askWarp(probe, entry, a, {std::move(part)});
        if (answer.failure)
            raise(*answer.failure);
        return std::move(answer.outputs.front());
    });
}

std::vector<float> SubmittedWarps::density(const catalog::WarpEntry &entry,
                                           std::span<const battery::Output> points,
                                           double a) const {
    BoxedProbe probe(m_parts->sandbox, m_parts->executable);
    return askInParts(points, [&](std::vector<battery::Output> part) {
        DensityAnswer answer = askDensity(probe, entry, a, {std::move(part)});
        if (answer.failure)
            raise(*answer.failure);
        return std::move(answer.densities.front());
    });
}

} // namespace grader
