// SPDX-License-Identifier: MIT
#include "warp_samples.h"

#include <grader/checks/answer.h>

namespace grader {

namespace {

protocol::Request requestOf(protocol::Op op, const catalog::WarpEntry &warp, double parameter) {
    protocol::Request request;
    request.op = op;
    request.text = warp.id;
    request.parameter = static_cast<float>(parameter);
    return request;
}

} // namespace

WarpAnswer askWarp(ProbeClient &probe, const catalog::WarpEntry &warp, double parameter,
                   const std::vector<std::vector<battery::Input>> &inputs) {
    protocol::RequestGroup group;
    for (const auto &list : inputs) {
        protocol::Request request = requestOf(protocol::Op::WarpSample, warp, parameter);
        for (const battery::Input &input : list) {
            request.values.push_back(input.u);
            request.values.push_back(input.v);
        }
        group.requests.push_back(std::move(request));
    }
    WarpAnswer result;
    const ProbeAnswer answer = probe.ask(group);
    result.failure = unanswered(answer);
    if (result.failure)
        return result;
    for (const protocol::Response &response : answer.responses) {
        std::vector<battery::Output> outputs;
        const auto dimension = static_cast<std::size_t>(warp.dimension);
        for (std::size_t at = 0; at + dimension <= response.values.size(); at += dimension)
            outputs.push_back({response.values[at], response.values[at + 1],
                               warp.dimension == 3 ? response.values[at + 2] : 0.0F});
        result.outputs.push_back(std::move(outputs));
    }
    return result;
}

DensityAnswer askDensity(ProbeClient &probe, const catalog::WarpEntry &warp, double parameter,
                         const std::vector<std::vector<battery::Output>> &points) {
    protocol::RequestGroup group;
    for (const auto &list : points) {
        protocol::Request request = requestOf(protocol::Op::WarpDensity, warp, parameter);
        for (const battery::Output &point : list) {
            request.values.push_back(point.x);
            request.values.push_back(point.y);
            if (warp.dimension == 3)
                request.values.push_back(point.z);
        }
        group.requests.push_back(std::move(request));
    }
    DensityAnswer result;
    ProbeAnswer answer = probe.ask(group);
    result.failure = unanswered(answer);
    if (result.failure)
        return result;
    for (protocol::Response &response : answer.responses)
        result.densities.push_back(std::move(response.values));
    return result;
}

} // namespace grader
