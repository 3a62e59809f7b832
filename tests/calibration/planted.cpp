// SPDX-License-Identifier: MIT
#include "planted.h"

namespace calibration {

namespace {

constexpr int kLights = 5; ///< of kPlantedScene

void scale(float *color, double factor) {
    for (int c = 0; c < 3; ++c)
        color[c] *= static_cast<float>(factor);
}

std::size_t tileOf(std::size_t pixel) {
    return pixel / kSide / kTileSize * (kSide / kTileSize) + pixel % kSide / kTileSize;
}

} // namespace

const char *const kPlantedScene = "table";

std::vector<Planted> plantedMistakes(const std::string &only) {
    std::vector<Planted> result = {{"nothing", [](std::size_t, float *) {}, Asked::NoFail}};

    struct Factor {
        const char *name;
        double value;
        Asked asked;
    };

    // A judgement that has found the image within 2 %, and its tiles within 15 %, looks no further.
    for (const Factor &factor : {Factor{"0.5 % brighter", 1.005, Asked::Nothing},
                                 Factor{"1 % brighter", 1.01, Asked::Nothing},
                                 Factor{"2 % brighter", 1.02, Asked::AllFail},
                                 Factor{"5 % brighter", 1.05, Asked::AllFail}})
        result.push_back({factor.name,
                          [value = factor.value](std::size_t, float *c) { scale(c, value); },
                          factor.asked});
    result.push_back({"one tile 10 % brighter",
                      [](std::size_t pixel, float *c) { scale(c, tileOf(pixel) == 9 ? 1.1 : 1); },
                      Asked::Nothing});
    result.push_back({"a black pixel", [](std::size_t pixel, float *c) {
                          scale(c, pixel == 20 * kSide + 12 ? 0 : 1);
                      }});
    result.push_back({"tiles 3 % brighter and darker",
                      [](std::size_t pixel, float *c) {
                          const std::size_t tile = tileOf(pixel);
                          scale(c, (tile + tile / 4) % 2 == 0 ? 1.03 : 0.97);
                      },
                      Asked::Nothing});
    result.push_back({"1 / lights forgotten", [](std::size_t, float *c) {
                          scale(c, 1.0 / kLights);
                      }});
    result.push_back(
        {"shadow margin of 0.6", [](std::size_t, float *) {}, Asked::AllFail, "wide_margin"});
    std::erase_if(result, [&](const Planted &mistake) {
        return std::string(mistake.name).find(only) == std::string::npos;
    });
    return result;
}

} // namespace calibration
