// SPDX-License-Identifier: MIT
// The generator PCG-XSH-RR 64/32 (O'Neill 2014, https://www.pcg-random.org) under the names that
// Nori's code calls it by.
#pragma once

#include <math.h>
#include <stdint.h>

#include <algorithm>
#include <cstring>

#define PCG32_DEFAULT_STATE 0x853c49e6748fea9bULL
#define PCG32_DEFAULT_STREAM 0xda3e39cb94b95bdbULL
#define PCG32_MULT 0x5851f42d4c957f2dULL

struct pcg32 {
    uint64_t state; ///< position on the stream
    uint64_t inc;   ///< which stream; odd

    pcg32() : state(PCG32_DEFAULT_STATE), inc(PCG32_DEFAULT_STREAM) {}

    pcg32(uint64_t initstate, uint64_t initseq = 1u) { seed(initstate, initseq); }

    void seed(uint64_t initstate, uint64_t initseq = 1) {
        state = 0U;
        inc = (initseq << 1u) | 1u;
        nextUInt();
        state += initstate;
        nextUInt();
    }

    /// Uniform over all 32-bit numbers.
    uint32_t nextUInt() {
        const uint64_t old = state;
        state = old * PCG32_MULT + inc;
        const auto shifted = static_cast<uint32_t>(((old >> 18u) ^ old) >> 27u);
        const auto rotation = static_cast<uint32_t>(old >> 59u);
        return (shifted >> rotation) | (shifted << ((~rotation + 1u) & 31u));
    }

    /// Uniform over 0 .. bound - 1.
    uint32_t nextUInt(uint32_t bound) {
        const uint32_t threshold = (~bound + 1u) % bound;
        while (true) {
            const uint32_t r = nextUInt();
            if (r >= threshold)
                return r % bound;
        }
    }

    /// Uniform in [0, 1), a multiple of 2^-23.
    float nextFloat() {
        const uint32_t bits = (nextUInt() >> 9) | 0x3f800000u;
        float f;
        std::memcpy(&f, &bits, sizeof f);
        return f - 1.0f;
    }

    /// Uniform in [0, 1), a multiple of 2^-32.
    double nextDouble() {
        const uint64_t bits = (static_cast<uint64_t>(nextUInt()) << 20) | 0x3ff0000000000000ULL;
        double d;
        std::memcpy(&d, &bits, sizeof d);
        return d - 1.0;
    }

    /// Skips `delta` numbers in O(log delta) (Brown 1994); negative: goes back.
    void advance(int64_t delta) {
        uint64_t mult = PCG32_MULT, plus = inc, accMult = 1u, accPlus = 0u;
        for (auto steps = static_cast<uint64_t>(delta); steps > 0; steps >>= 1) {
            if ((steps & 1) != 0) {
                accMult *= mult;
                accPlus = accPlus * mult + plus;
            }
            plus = (mult + 1) * plus;
            mult *= mult;
        }
        state = accMult * state + accPlus;
    }

    /// How far this generator is ahead of another one of the same stream.
    int64_t operator-(const pcg32 &other) const {
        uint64_t mult = PCG32_MULT, plus = inc, current = other.state, bit = 1u, distance = 0u;
        while (state != current) {
            if ((state & bit) != (current & bit)) {
                current = current * mult + plus;
                distance |= bit;
            }
            bit <<= 1;
            plus = (mult + 1) * plus;
            mult *= mult;
        }
        return static_cast<int64_t>(distance);
    }

    template <typename Iterator>
    void shuffle(Iterator begin, Iterator end) {
        for (Iterator it = end - 1; it > begin; --it)
            std::iter_swap(it, begin + nextUInt(static_cast<uint32_t>(it - begin + 1)));
    }

    bool operator==(const pcg32 &other) const { return state == other.state && inc == other.inc; }

    bool operator!=(const pcg32 &other) const { return !operator==(other); }
};
