// SPDX-License-Identifier: MIT
#include "reference_answers.h"

#include <grader/digest.h>

namespace grader {

namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;

std::string keyOf(const protocol::RequestGroup &group) {
    return sha256Hex(protocol::encode(group));
}

std::size_t sizeOf(const ProbeAnswer &answer) {
    std::size_t bytes = 0;
    for (const protocol::Response &response : answer.responses)
        bytes += response.values.size() * sizeof(float);
    return bytes;
}

} // namespace

const ProbeAnswer *ReferenceAnswers::find(const protocol::RequestGroup &group) const {
    if (m_answers.empty())
        return nullptr;
    const auto found = m_answers.find(keyOf(group));
    return found != m_answers.end() ? &found->second : nullptr;
}

void ReferenceAnswers::keep(const protocol::RequestGroup &group, const ProbeAnswer &answer) {
    const std::size_t bytes = sizeOf(answer);
    if (!answer.complete() || m_bytes + bytes > kMostBytes)
        return;
    if (m_answers.emplace(keyOf(group), answer).second)
        m_bytes += bytes;
}

} // namespace grader
