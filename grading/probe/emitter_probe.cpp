// SPDX-License-Identifier: MIT
#include <nori/emitter.h>
#include <probe/probe.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace probe {

namespace {

using nori::Color3f;
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

void appendSample(const nori::Emitter &emitter, const float *&at, Values &values) {
    EmitterQueryRecord record = emptyRecord(readVector<Point3f>(at));
    const Point2f sample = readVector<Point2f>(at);
    const float optional = *at++;
    append(values, emitter.sample(record, sample, optional));
    append(values, record.p);
    append(values, record.n);
    append(values, record.uv);
    append(values, record.wi);
    values.push_back(record.dist);
    values.push_back(record.pdf);
    values.push_back(emitter.pdf(EmitterQueryRecord(record)));
    append(values, emitter.eval(EmitterQueryRecord(record)));
    values.push_back(record.emitter == &emitter ? 1.0f : 0.0f);
}

void appendEval(const nori::Emitter &emitter, const float *&at, Values &values) {
    const Point3f ref = readVector<Point3f>(at);
    const Point3f p = readVector<Point3f>(at);
    const nori::Normal3f n = readVector<nori::Normal3f>(at);
    const Point2f uv = readVector<Point2f>(at);
    EmitterQueryRecord record(&emitter, ref, p, n, uv);
    record.pdf = std::numeric_limits<float>::quiet_NaN();
    append(values, emitter.eval(record));
    values.push_back(emitter.pdf(record));
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
