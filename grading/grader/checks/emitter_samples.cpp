// SPDX-License-Identifier: MIT
#include "emitter_samples.h"

#include <grader/checks/answer.h>
#include <grader/checks/emitter_diagnosis.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

constexpr double kRelativeTolerance = 1e-3;

void append(std::vector<float> &values, const auto &v) {
    for (Eigen::Index i = 0; i < v.size(); ++i)
        values.push_back(static_cast<float>(v[i]));
}

Vector3d read3(const float *&values) {
    const Vector3d v(values[0], values[1], values[2]);
    values += 3;
    return v;
}

double read1(const float *&values) {
    return static_cast<double>(*values++);
}

Vector2d read2(const float *&values) {
    const Vector2d v(values[0], values[1]);
    values += 2;
    return v;
}

bool agrees(const Vector3d &a, const Vector3d &b) {
    return a.allFinite() && b.allFinite() &&
           (a - b).norm() <= kRelativeTolerance * std::max(a.norm(), b.norm());
}

protocol::RequestGroup groupOf(const TestScene &scene, protocol::Request request, int emitter) {
    protocol::RequestGroup group;
    group.files = scene.files();
    request.text = TestScene::kFileName;
    request.index = static_cast<std::uint32_t>(emitter);
    group.requests.push_back(std::move(request));
    return group;
}

} // namespace

protocol::RequestGroup emitterSampleRequest(const TestScene &scene, int emitter,
                                            const std::vector<Vector3d> &refs, std::uint64_t seed) {
    SceneRandom random(seed);
    protocol::Request request;
    request.op = protocol::Op::EmitterSample;
    for (const Vector3d &ref : refs) {
        append(request.values, ref);
        for (int i = 0; i < 3; ++i)
            request.values.push_back(random.nextFloat());
    }
    return groupOf(scene, std::move(request), emitter);
}

EmitterAnswer askEmitterSamples(CheckContext &context, const TestScene &scene, int emitter,
                                const std::vector<Vector3d> &refs, std::uint64_t seed) {
    EmitterAnswer result;
    const ProbeAnswer answer = context.ask(emitterSampleRequest(scene, emitter, refs, seed));
    result.failure = unanswered(answer);
    if (result.failure)
        return result;
    const float *values = answer.responses[0].values.data();
    for (const Vector3d &ref : refs) {
        EmitterSampleRow row;
        row.ref = ref.cast<float>().cast<double>();
        row.value = read3(values);
        row.p = read3(values);
        row.n = read3(values);
        row.uv = read2(values);
        row.wi = read3(values);
        row.dist = read1(values);
        row.recordPdf = read1(values);
        row.pdf = read1(values);
        row.eval = read3(values);
        row.emitterSet = read1(values) != 0;
        result.rows.push_back(row);
    }
    return result;
}

EvalAnswer askEmitterEval(CheckContext &context, const TestScene &scene, int emitter,
                          const std::vector<EmitterQuery> &queries, bool reference) {
    protocol::Request request;
    request.op = protocol::Op::EmitterEval;
    for (const EmitterQuery &query : queries) {
        append(request.values, query.ref);
        append(request.values, query.p);
        append(request.values, query.n);
        append(request.values, query.uv);
    }
    EvalAnswer result;
    const protocol::RequestGroup group = groupOf(scene, std::move(request), emitter);
    const ProbeAnswer answer = reference ? context.askReference(group) : context.ask(group);
    result.failure = unanswered(answer);
    if (result.failure)
        return result;
    const float *values = answer.responses[0].values.data();
    for (std::size_t i = 0; i < queries.size(); ++i) {
        EmitterEvalRow row;
        row.eval = read3(values);
        row.pdf = read1(values);
        result.rows.push_back(row);
    }
    return result;
}

SampleConvention detectConvention(const std::vector<EmitterSampleRow> &rows, int *wrong) {
    int asValue = 0;
    int asQuotient = 0;
    int total = 0;
    for (const EmitterSampleRow &row : rows) {
        // Where no light comes from, both conventions return black, whatever eval/0 is.
        const bool dark = row.eval.allFinite() && row.eval.isZero();
        if (dark && row.value.allFinite() && row.value.isZero())
            continue;
        ++total;
        asValue += agrees(row.value, row.eval) ? 1 : 0;
        asQuotient += row.pdf > 0 && agrees(row.value, row.eval / row.pdf) ? 1 : 0;
    }
    // Single rows at grazing angles may round differently.
    const int needed = total - total / 500;
    if (wrong != nullptr)
        *wrong = total - std::max(asValue, asQuotient);
    if (asValue >= needed && asQuotient >= needed)
        return SampleConvention::Either;
    if (asValue >= needed)
        return SampleConvention::Value;
    return asQuotient >= needed ? SampleConvention::ValueOverPdf : SampleConvention::Neither;
}

CheckResult judgeSampleValue(const std::vector<EmitterSampleRow> &rows, const char *otherwise) {
    int wrong = 0;
    const SampleConvention convention = detectConvention(rows, &wrong);
    CheckResult result =
        judgeRows(convention == SampleConvention::Neither ? static_cast<std::size_t>(wrong) : 0,
                  rows.size(), "sampled values", guessSampleValue(rows, otherwise));
    if (convention == SampleConvention::Value)
        result.message += " It returns the bare radiance; the header asks for radiance / pdf, both "
                          "are accepted.";
    if (convention == SampleConvention::Value || convention == SampleConvention::ValueOverPdf)
        result.sampleDivides = convention == SampleConvention::ValueOverPdf;
    return result;
}

CheckResult judgeRows(std::size_t wrong, std::size_t total, const std::string &what,
                      std::vector<Guess> diagnoses) {
    CheckResult result =
        makeResult(wrong == 0 ? Verdict::Pass : Verdict::Fail,
                   fmt::format("{} of {} {} are wrong.", wrong, total, what), std::move(diagnoses));
    result.effect = total > 0 ? static_cast<double>(wrong) / static_cast<double>(total) : 1;
    return result;
}

} // namespace grader
