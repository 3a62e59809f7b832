// SPDX-License-Identifier: MIT
//
// What the decoder says of a file, if the file has taken it over.
#include <protocol/image.h>

#include <stdexcept>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    using namespace protocol;
    try {
        const ImageAnswer answer = decodeImageAnswer(bytes.data(), bytes.size());
        for (const Channel &channel : answer.image.channels) {
            require(channel.values.size() == static_cast<std::size_t>(answer.image.width) *
                                                 static_cast<std::size_t>(answer.image.height),
                    "channels have the size of their image");
            require(answer.image.channel(channel.name) == &channel, "each name is there once");
        }
    } catch (const std::runtime_error &) {
    }
}
