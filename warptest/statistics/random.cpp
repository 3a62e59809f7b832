// SPDX-License-Identifier: MIT
#include "random.h"

namespace statistics {

namespace {

constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15U;

std::uint64_t hashText(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U; // FNV-1a, 64 bits
    for (const char character : text) {
        hash ^= static_cast<unsigned char>(character);
        hash *= 0x100000001b3U;
    }
    return hash;
}

} // namespace

std::uint64_t mix64(std::uint64_t word) {
    word = (word ^ (word >> 30U)) * 0xbf58476d1ce4e5b9U;
    word = (word ^ (word >> 27U)) * 0x94d049bb133111ebU;
    return word ^ (word >> 31U);
}

std::uint64_t deriveSeed(std::uint64_t runSeed, std::string_view purpose, unsigned stage,
                         unsigned replicate) {
    std::uint64_t seed = mix64(runSeed + kGoldenGamma);
    for (const std::uint64_t part :
         {hashText(purpose), std::uint64_t{stage}, std::uint64_t{replicate}}) {
        seed = mix64((seed ^ part) + kGoldenGamma);
    }
    return seed;
}

std::uint64_t Random::nextBits() {
    m_state += kGoldenGamma;
    return mix64(m_state);
}

double Random::nextDouble() {
    return static_cast<double>(nextBits() >> 11U) * 0x1p-53;
}

float Random::nextFloat() {
    return static_cast<float>(nextBits() >> 41U) * 0x1p-23F;
}

std::uint64_t Random::nextBelow(std::uint64_t bound) {
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::uint64_t>((Wide{nextBits()} * bound) >> 64U);
}

} // namespace statistics
