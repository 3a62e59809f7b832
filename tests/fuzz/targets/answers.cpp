// SPDX-License-Identifier: MIT
//
// The answers' memory, which a submission writes as it likes. The first two bytes choose the
// questions.
#include <protocol/request.h>

#include <cmath>
#include <cstring>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    using namespace protocol;
    if (bytes.size() < 2)
        return;
    RequestGroup group;
    for (int i = 0; i < 1 + bytes[0] % 4; ++i) {
        Request request;
        request.text = "sphere";
        request.values.assign(static_cast<std::size_t>(2 * (bytes[1] & 7)), 0.5F);
        group.requests.push_back(request);
    }
    bytes.remove_prefix(2);
    const SlotLayout layout = slotLayout(group);
    std::string memory(layout.size, '\0');
    clearSlots(layout, memory.data());
    // Only the head of each slot matters: an input is spread over them, 24 bytes each.
    constexpr std::size_t kHead = 24;
    for (const std::size_t offset : layout.offsets) {
        const std::size_t size = std::min(bytes.size(), kHead);
        std::memcpy(&memory[offset], bytes.data(), size);
        bytes.remove_prefix(size);
    }
    for (std::size_t i = 0; i < group.requests.size(); ++i) {
        const Response response = readSlot(layout, group, i, memory.data());
        require(response.message.size() <= 2000, "messages are capped");
        require(std::isfinite(response.cpuSeconds) && response.cpuSeconds >= 0, "time is a time");
        require(response.values.size() ==
                    (response.state == State::Done ? group.requests[i].resultSize() : 0),
                "an answer has the shape of its question");
    }
}
