// SPDX-License-Identifier: MIT
#include "hand_in_renderer.h"

#include <grader/build/compiler.h>
#include <grader/build/variant_builder.h>
#include <grader/checks/radiance_samples.h>
#include <grader/engine/groups.h>
#include <grader/error.h>
#include <grader/prober/prober.h>
#include <grader/scenes/scene_bundle.h>
#include <grader/scenes/test_scene.h>
#include <grader/submission/submission.h>
#include <grader/text_file.h>
#include <statistics/random.h>

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr BoxLimits kLimits = {.cpu = std::chrono::seconds(300),
                               .wall = std::chrono::seconds(900),
                               .memoryBytes = std::uint64_t{3} << 30,
                               .fileBytes = std::uint64_t{64} << 20,
                               .logBytes = std::uint64_t{1} << 20,
                               .processes = 32};

/// Samples of one question: their answer takes 120 MB.
constexpr std::size_t kMostSamples = 10'000'000;

/// Planes as `nori --moments` names them.
protocol::Image imageOf(const RadianceSamples &samples, const RenderJob &job, double cpuSeconds) {
    protocol::Image image;
    image.format = "exr"; // what it would be as a file of nori's
    image.width = job.width;
    image.height = job.height;
    image.attributes = {{"cpuSeconds", std::to_string(cpuSeconds)},
                        {"spp", std::to_string(job.samplesPerPixel)}};
    const RadianceMoments moments = momentsOf(samples);
    const auto add = [&](const std::string &name, std::size_t c, auto member) {
        protocol::Channel channel{name, {}};
        for (const statistics::MomentSummary &pixel : moments[c])
            channel.values.push_back(static_cast<float>(pixel.*member));
        image.channels.push_back(std::move(channel));
    };
    using statistics::MomentSummary;
    constexpr const char *kNames[] = {"R", "G", "B"};
    add("count.Y", 0, &MomentSummary::count);
    for (std::size_t c = 0; c < 3; ++c) {
        add(kNames[c], c, &MomentSummary::mean);
        add(fmt::format("mean.{}", kNames[c]), c, &MomentSummary::mean);
        add(fmt::format("variance.{}", kNames[c]), c, &MomentSummary::variance);
        add(fmt::format("third.{}", kNames[c]), c, &MomentSummary::thirdCentral);
    }
    std::sort(image.channels.begin(), image.channels.end(),
              [](const auto &a, const auto &b) { return a.name < b.name; });
    return image;
}

} // namespace

HandInRenderer::HandInRenderer(const Sandbox &sandbox, const fs::path &handIn, int jobs)
    : m_sandbox(sandbox) {
    const Submission submission = readSubmission(handIn);
    m_name = submission.name;
    m_digest = submission.digest;
    const Cache cache;
    Compiler compiler(sandbox, cache);
    VariantBuilder builder(compiler, submission, jobs);
    const Variant own = builder.build(studentPlan(findGroup("direct_ems")));
    if (!own.executable || !own.failures.empty())
        throw GraderError(fmt::format("{}: cannot be built: {}", handIn.string(),
                                      own.failures.empty() ? "no reason is known"
                                                           : own.failures.front().describe()));
    m_executable = *own.executable;
}

RenderEnd HandInRenderer::render(const RenderJob &job, const std::atomic<bool> &interrupted) const {
    protocol::RequestGroup group;
    group.files = readSceneBundle(job.scene, ImageSize{job.width, job.height}).files;
    protocol::Request request;
    request.op = protocol::Op::Image;
    request.text = TestScene::kFileName;
    request.values.resize(static_cast<std::size_t>(job.width) * job.height);
    std::iota(request.values.begin(), request.values.end(), 0.0F);
    RadianceSamples samples(request.values.size());
    const int most =
        std::max(1, static_cast<int>(kMostSamples / std::max<std::size_t>(1, samples.places())));
    double cpuSeconds = 0;
    for (int done = 0; done < job.samplesPerPixel;) {
        if (interrupted)
            return RenderEnd::Interrupted;
        const int repeats = std::min(most, job.samplesPerPixel - done);
        request.repeats = static_cast<std::uint32_t>(repeats);
        request.seed = statistics::deriveSeed(static_cast<std::uint64_t>(job.seed), "hand-in",
                                              static_cast<unsigned>(done));
        group.requests = {request};
        const ProbeAnswer answer = askProbe(m_sandbox, m_executable, group, kLimits);
        if (!answer.complete())
            throw GraderError(fmt::format("{}: the code that was handed in does not render it: {}",
                                          job.scene.string(),
                                          answer.responses.front().state == protocol::State::Threw
                                              ? answer.responses.front().message
                                              : describe(answer.outcome.end)));
        samples.add(answer.responses.front().values, repeats);
        cpuSeconds += answer.responses.front().cpuSeconds;
        done += repeats;
    }
    writeTextFile(job.output, protocol::encode(protocol::ImageAnswer{
                                  imageOf(samples, job, cpuSeconds), {}, {}}));
    return RenderEnd::Done;
}

protocol::Image readPlanes(const fs::path &file) {
    const std::string bytes = readTextFile(file);
    try {
        return protocol::decodeImageAnswer(bytes.data(), bytes.size()).image;
    } catch (const std::runtime_error &error) {
        throw GraderError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

} // namespace grader
