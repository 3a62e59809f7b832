// SPDX-License-Identifier: MIT
//
// A group of questions, and the answers' layout that follows from it.
#include <protocol/request.h>

#include <cstring>
#include <stdexcept>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    using namespace protocol;
    try {
        const RequestGroup group = decode(bytes.data(), bytes.size());
        require(encode(group) == bytes, "what is decoded was encoded");
        slotLayout(group);
    } catch (const std::runtime_error &) {    // not of this protocol
    } catch (const std::invalid_argument &) { // values of another shape than the op asks for
    }
}
