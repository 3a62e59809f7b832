// SPDX-License-Identifier: MIT
#pragma once

#include <nori/scene.h>
#include <protocol/request.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

/// What runs with a submission's code: answers requests with raw numbers and judges nothing. Only
/// Nori 2's own interface is used, since a submission's headers may stand in for ours.
namespace probe {

/// Scenes of the request group, loaded when first asked for.
class SceneStore {
public:
    /// Writes the group's files below the folder `scene` of the working folder: in the box, that
    /// is /tmp/scene.
    /// \throws std::runtime_error  if a name leads out of it, or it cannot be written
    explicit SceneStore(const std::vector<protocol::File> &files);

    /// \throws whatever loading throws; std::runtime_error if the file holds no scene
    nori::Scene &get(const std::string &name);

    /// The scene, with Integrator::preprocess() called once: for Li alone, so that a mistake in it
    /// costs no answer about a mesh or an emitter.
    /// \throws as get(), and whatever preprocess() throws
    nori::Scene &getPrepared(const std::string &name);

private:
    std::string m_root; ///< absolute: a submission may change the working folder
    // Never destroyed: the process just ends.
    std::map<std::string, nori::Scene *> m_scenes;
    std::set<std::string> m_prepared;
};

using Values = std::vector<float>;

// Answers, Request::resultSize() floats. \throws std::exception and whatever the submission throws
Values answerWarp(const protocol::Request &request);
Values answerMesh(const protocol::Request &request, const nori::Scene &scene);
Values answerEmitter(const protocol::Request &request, const nori::Scene &scene);
Values answerRadiance(const protocol::Request &request, nori::Scene &scene);
Values answerImage(const protocol::Request &request, nori::Scene &scene);
Values answerFilm(const protocol::Request &request, nori::Scene &scene);
Values answerFacts(const nori::Scene &scene);

/// Splits the rows of a request among threads that start at the same time.
/// \param rowSize  floats of a row, none of which depends on another row
/// \param threads  at most 16 are started
/// \throws whatever `answer` throws in the first thread that threw
Values answerOnThreads(const protocol::Request &request, std::size_t rowSize, std::uint32_t threads,
                       const std::function<Values(const protocol::Request &)> &answer);

// Reading and writing rows of floats. Call append() by its full name: for an argument of a type of
// Nori's, a function `append` of the submission's would be looked up as well.
template <typename V>
V readVector(const float *&at) {
    V v;
    for (int i = 0; i < static_cast<int>(v.size()); ++i)
        v[i] = *at++;
    return v;
}

template <typename V>
void append(Values &values, const V &v) {
    for (int i = 0; i < static_cast<int>(v.size()); ++i)
        values.push_back(v[i]);
}

} // namespace probe
