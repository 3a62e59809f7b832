// SPDX-License-Identifier: MIT
#include <nori/emitter.h>
#include <probe/probe.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace probe {

namespace {

using nori::EmitterQueryRecord;
using nori::Point2f;
using nori::Point3f;

const nori::Emitter &emitterOf(const protocol::Request &request, const nori::Scene &scene) {
    const std::vector<nori::Emitter *> &lights = scene.getLights();
    if (request.index >= lights.size())
        throw std::out_of_range("the scene has no such emitter");
    return *lights[request.index];
}

/// What `sample` may leave unset is set to what can be told apart.
EmitterQueryRecord emptyRecord(const Point3f &ref) {
    EmitterQueryRecord record(ref);
    record.emitter = nullptr;
    record.pdf = std::numeric_limits<float>::quiet_NaN();
    record.dist = std::numeric_limits<float>::quiet_NaN();
    return record;
}

/// The value of `call()`; what it throws says in which function.
template <typename Call>
auto named(const char *function, const Call &call) {
    try {
        return call();
    } catch (const std::exception &error) {
        throw std::runtime_error(std::string(function) + ": " + error.what());
    } catch (...) {
        throw std::runtime_error(std::string(function) + ": something that is no std::exception");
    }
}

nori::Color3f evalOf(const nori::Emitter &emitter, const EmitterQueryRecord &record) {
    return named("Emitter::eval", [&] { return emitter.eval(record); });
}

float pdfOf(const nori::Emitter &emitter, const EmitterQueryRecord &record) {
    return named("Emitter::pdf", [&] { return emitter.pdf(record); });
}

void appendSample(const nori::Emitter &emitter, const float *&at, Values &values) {
    EmitterQueryRecord record = emptyRecord(probe::readVector<Point3f>(at));
    const auto sample = probe::readVector<Point2f>(at);
    const float optional = *at++;
    const nori::Color3f value =
        named("Emitter::sample", [&] { return emitter.sample(record, sample, optional); });
    probe::append(values, value);
    probe::append(values, record.p);
    probe::append(values, record.n);
    probe::append(values, record.uv);
    probe::append(values, record.wi);
    values.push_back(record.dist);
    values.push_back(record.pdf);
    values.push_back(pdfOf(emitter, EmitterQueryRecord(record)));
    probe::append(values, evalOf(emitter, EmitterQueryRecord(record)));
    values.push_back(record.emitter == &emitter ? 1.0f : 0.0f);
}

void appendEval(const nori::Emitter &emitter, const float *&at, Values &values) {
    const auto ref = readVector<Point3f>(at);
    const auto p = readVector<Point3f>(at);
    const auto n = readVector<nori::Normal3f>(at);
    const auto uv = readVector<Point2f>(at);
    EmitterQueryRecord record(&emitter, ref, p, n, uv);
    record.pdf = std::numeric_limits<float>::quiet_NaN();
    probe::append(values, evalOf(emitter, EmitterQueryRecord(record)));
    values.push_back(pdfOf(emitter, EmitterQueryRecord(record)));
}

void appendPick(const nori::Scene &scene, float u, Values &values) {
    float pdf = std::numeric_limits<float>::quiet_NaN();
    const nori::Emitter *emitter = scene.sampleEmitter(u, pdf);
    const std::vector<nori::Emitter *> &lights = scene.getLights();
    const auto found = std::find(lights.begin(), lights.end(), emitter);
    const bool known = found != lights.end();
    values.push_back(known ? static_cast<float>(found - lights.begin()) : -1.0f);
    values.push_back(pdf);
    values.push_back(known ? scene.pdfEmitter(emitter) : std::numeric_limits<float>::quiet_NaN());
}

} // namespace

Values answerEmitter(const protocol::Request &request, const nori::Scene &scene) {
    Values values;
    values.reserve(request.resultSize());
    const float *at = request.values.data();
    const float *end = at + request.values.size();
    while (at < end) {
        if (request.op == protocol::Op::EmitterPick)
            appendPick(scene, *at++, values);
        else if (request.op == protocol::Op::EmitterSample)
            appendSample(emitterOf(request, scene), at, values);
        else
            appendEval(emitterOf(request, scene), at, values);
    }
    return values;
}

} // namespace probe
