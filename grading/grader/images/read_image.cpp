// SPDX-License-Identifier: MIT
#include "read_image.h"

#include <grader/build/cache.h>
#include <grader/error.h>
#include <grader/sandbox/memory_file.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader {

namespace {

namespace fs = std::filesystem;
using protocol::ImageAnswer;

constexpr char kDecoderInside[] = "/decoder";

/// Largest answer: the values of the largest image, and some text.
constexpr std::uint64_t kAnswerBytes = 4 * std::uint64_t{protocol::kLargestImage} + (1U << 20U);

/// What the decoder wrote; `fate` tells how it ended, for when that is nothing whole.
ImageReading readAnswer(const Descriptor &out, const std::string &fate) {
    struct stat status {};

    if (::fstat(out.get(), &status) != 0)
        throw GraderError("the decoder's memory cannot be read");
    try {
        const std::string bytes = readMemoryFile(out, static_cast<std::size_t>(status.st_size));
        ImageAnswer answer = protocol::decodeImageAnswer(bytes.data(), bytes.size());
        if (answer.fault == protocol::ImageFault{})
            return std::move(answer.image);
        return NoImage{answer.fault, answer.message};
    } catch (const std::runtime_error &) {
        return NoImage{std::nullopt, "the program that decodes it gave no image: " + fate};
    }
}

std::string runBoxed(const Sandbox &sandbox, const Descriptor &in, const Descriptor &out) {
    static const fs::path decoder = Cache().install(NORI_DECODER);
    BoxSpec spec;
    spec.argv = {kDecoderInside};
    spec.binds = {{decoder, kDecoderInside, false}};
    spec.limits.fileBytes = kAnswerBytes;
    spec.descriptors = {in.get(), out.get()};
    const BoxOutcome outcome = sandbox.run(spec);
    if (const std::string reason = ownFailure(outcome.end); !reason.empty())
        throw GraderError("the decoder was not run to its end: " + reason);
    return describe(outcome.end);
}

std::string runPlain(const Descriptor &in, const Descriptor &out) {
    const pid_t process = ::fork();
    if (process < 0)
        throw GraderError("the decoder could not be started: too many processes");
    if (process == 0) {
        // High first: 3 and 4 may be the descriptors themselves.
        constexpr int kSpare = 100;
        ::dup2(in.get(), kSpare);
        ::dup2(out.get(), kSpare + 1);
        ::dup2(kSpare, 3);
        ::dup2(kSpare + 1, 4);
        ::execl(NORI_DECODER, NORI_DECODER, nullptr);
        ::_exit(2);
    }
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFSIGNALED(status) ? fmt::format("signal {} ended it", WTERMSIG(status))
                               : fmt::format("it ended with code {}", WEXITSTATUS(status));
}

template <typename Run>
ImageReading decodeWith(std::string_view bytes, const Run &run) {
    const Descriptor in = makeMemoryFile("image", bytes);
    sealMemoryFile(in, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW);
    const Descriptor out = makeMemoryFile("answer", {});
    return readAnswer(out, run(in, out));
}

} // namespace

ImageReading decodeImage(const Sandbox &sandbox, std::string_view bytes) {
    return decodeWith(bytes, [&](const Descriptor &in, const Descriptor &out) {
        return runBoxed(sandbox, in, out);
    });
}

protocol::Image readImage(const Sandbox &sandbox, const std::filesystem::path &file) {
    if (!std::filesystem::exists(file))
        throw GraderError(fmt::format("{}: no such file", file.string()));
    const std::string bytes = readTextFile(file);
    ImageReading reading = sandbox.level() >= SandboxLevel::S2 ? decodeImage(sandbox, bytes)
                                                               : decodeWith(bytes, runPlain);
    if (const auto *none = std::get_if<NoImage>(&reading))
        throw GraderError(fmt::format("{}: {}", file.string(), none->message));
    return std::get<protocol::Image>(std::move(reading));
}

} // namespace grader
