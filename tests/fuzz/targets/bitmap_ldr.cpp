// SPDX-License-Identifier: MIT
//
// A texture: PNG or JPEG.
#include <nori/bitmap.h>

#include "../image_size.h"
#include "../target.h"

namespace {

/// True if a JPEG file claims many pixels: a marker of a frame, then length, precision, two sides.
bool isLargeJpeg(std::string_view bytes) {
    for (std::size_t i = 0; i + 9 < bytes.size(); ++i) {
        const auto at = [&](std::size_t k) {
            return static_cast<std::int64_t>(static_cast<unsigned char>(bytes[i + k]));
        };
        if (at(0) == 0xff && at(1) >= 0xc0 && at(1) <= 0xcf &&
            (at(5) * 256 + at(6)) * (at(7) * 256 + at(8)) > fuzz::kMostPixels)
            return true;
    }
    return false;
}

} // namespace

void fuzz::run(std::string_view bytes) {
    if (isLargePng(bytes) || isLargeJpeg(bytes))
        return;
    static const ScratchFile file;
    try {
        const nori::LDRBitmap bitmap(file.write(bytes));
        bitmap.eval(nori::Point2f(0.3f, 0.9f));
    } catch (const nori::NoriException &) {
    }
}
