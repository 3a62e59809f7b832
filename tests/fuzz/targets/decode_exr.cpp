// SPDX-License-Identifier: MIT
//
// A stranger's figure, as the decoder in the box reads it.
#include "../image_size.h"
#include "../target.h"
#include <decoder/decode.h>

void fuzz::run(std::string_view bytes) {
    if (isLargeImage(bytes))
        return;
    const protocol::ImageAnswer answer = decoder::decode(bytes.data(), bytes.size());
    if (answer.fault == protocol::ImageFault{}) {
        const std::string message = encode(answer);
        require(protocol::decodeImageAnswer(message.data(), message.size()).image.width ==
                    answer.image.width,
                "the grader reads what the decoder writes");
    }
}
