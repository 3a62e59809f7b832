// SPDX-License-Identifier: MIT
//
// An environment map.
#include <nori/bitmap.h>

#include "../image_size.h"
#include "../target.h"

void fuzz::run(std::string_view bytes) {
    if (isLargeImage(bytes))
        return;
    static const ScratchFile file;
    try {
        const nori::Bitmap bitmap(file.write(bytes));
        bitmap.eval(nori::Point2f(0.3f, 0.9f));
    } catch (const nori::NoriException &) {
    }
}
