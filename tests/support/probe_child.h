// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/request.h>

#include <string>
#include <vector>

namespace test {

/// How a probe ended and what it left, as the grader would read it.
struct ProbeRun {
    int exitCode = -1;    ///< -1: a signal ended it
    int signalNumber = 0; ///< 0: none
    std::vector<protocol::Response> responses;
};

/// Runs a probe as a plain child, without a sandbox, in a fresh working folder that is removed
/// afterwards. For probes made of our own code only. Killed after 20 s.
/// \throws std::runtime_error  if the system gives no memory, folder or process
ProbeRun runProbe(const std::string &executable, const protocol::RequestGroup &group);

/// As above, but with `questions` in place of an encoded group.
ProbeRun runProbe(const std::string &executable, const protocol::RequestGroup &group,
                  const std::string &questions);

/// A scene file with what Scene::activate() asks for besides `objects`.
protocol::File sceneFile(const std::string &objects, const std::string &integrator = "normals",
                         const std::string &name = "scene.xml");

/// A request on `scene.xml`.
protocol::Request sceneRequest(protocol::Op op, std::vector<float> values = {},
                               std::uint32_t index = 0);

/// The only answer to the only request. Fails the test unless it is Done: then all is 0.
std::vector<float> askOne(const std::string &executable, const protocol::File &scene,
                          const protocol::Request &request,
                          const std::vector<protocol::File> &more = {});

/// An OBJ file: the rectangle [-1, 1] x [-0.5, 0.5] at height 2, of two triangles, whose winding
/// looks down; uv runs from 0 to 1 along x and y; no vertex normals. Its area is 2.
protocol::File ceilingObj(const std::string &name = "ceiling.obj");

} // namespace test
