// SPDX-License-Identifier: MIT
#include <protocol/request.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

namespace protocol {

namespace {

constexpr std::size_t kMaxMessage = 2000;
constexpr std::size_t kAlignment = 64;

/// Starts a slot; the values follow it.
struct SlotHead {
    State state;
    std::uint32_t messageSize;
    double cpuSeconds;
    char message[kMaxMessage];
};

SlotHead readHead(const char *memory) {
    SlotHead head{};
    std::memcpy(&head, memory, sizeof head);
    return head;
}

} // namespace

SlotLayout slotLayout(const RequestGroup &group) {
    SlotLayout layout;
    for (const Request &request : group.requests) {
        layout.offsets.push_back(layout.size);
        const std::size_t size = sizeof(SlotHead) + request.resultSize() * sizeof(float);
        layout.size += (size + kAlignment - 1) / kAlignment * kAlignment;
    }
    return layout;
}

void clearSlots(const SlotLayout &layout, char *memory) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t at = 0; at + sizeof nan <= layout.size; at += sizeof nan)
        std::memcpy(memory + at, &nan, sizeof nan);
    for (const std::size_t offset : layout.offsets) {
        const SlotHead head{};
        std::memcpy(memory + offset, &head, sizeof head);
        const State pending = State::Pending;
        std::memcpy(memory + offset, &pending, sizeof pending);
    }
}

void writeSlot(const SlotLayout &layout, std::size_t request, const Response &response,
               char *memory) {
    char *slot = memory + layout.offsets.at(request);
    SlotHead head{};
    head.state = State::Pending;
    head.messageSize = static_cast<std::uint32_t>(std::min(response.message.size(), kMaxMessage));
    head.cpuSeconds = response.cpuSeconds;
    std::memcpy(head.message, response.message.data(), head.messageSize);
    std::memcpy(slot, &head, sizeof head);
    if (!response.values.empty())
        std::memcpy(slot + sizeof head, response.values.data(),
                    response.values.size() * sizeof(float));
    // State last: a slot that a crash interrupts reads as Pending.
    std::atomic_thread_fence(std::memory_order_release);
    std::memcpy(slot, &response.state, sizeof response.state);
}

Response readSlot(const SlotLayout &layout, const RequestGroup &group, std::size_t request,
                  const char *memory) {
    const char *slot = memory + layout.offsets.at(request);
    const SlotHead head = readHead(slot);
    Response response;
    const bool known = head.state == State::Done || head.state == State::Threw;
    if (!known || head.messageSize > kMaxMessage)
        return response;
    response.state = head.state;
    if (std::isfinite(head.cpuSeconds) && head.cpuSeconds >= 0)
        response.cpuSeconds = head.cpuSeconds;
    if (head.state == State::Threw) {
        response.message.assign(head.message, head.messageSize);
    } else {
        response.values.resize(group.requests[request].resultSize());
        if (!response.values.empty())
            std::memcpy(response.values.data(), slot + sizeof head,
                        response.values.size() * sizeof(float));
    }
    return response;
}

} // namespace protocol
