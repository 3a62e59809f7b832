// SPDX-License-Identifier: MIT
#include <protocol/request.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <random>
#include <stdexcept>

namespace {

/// Largest block that was asked for since it was last set to 0.
std::size_t largestAllocation = 0;

} // namespace

// Not inlined: g++ 12 would pair one of them with the other's malloc() or free() and warn.
[[gnu::noinline]] void *operator new(std::size_t size) {
    largestAllocation = std::max(largestAllocation, size);
    void *block = std::malloc(std::max<std::size_t>(size, 1));
    if (block == nullptr)
        throw std::bad_alloc();
    return block;
}

[[gnu::noinline]] void operator delete(void *block) noexcept {
    std::free(block);
}

[[gnu::noinline]] void operator delete(void *block, std::size_t) noexcept {
    std::free(block);
}

namespace protocol {
namespace {

RequestGroup sampleGroup() {
    RequestGroup group;
    group.files = {{"scene.xml", "<scene/>"},
                   {"ma\xc3\xb1"
                    "ana/mesh.obj",
                    std::string("\0\xff", 2)}};
    Request warp;
    warp.op = Op::WarpSample;
    warp.text = "beckmann";
    warp.parameter = 0.3F;
    warp.values = {0.0F, 0.25F, std::numeric_limits<float>::quiet_NaN(), -0.0F};
    Request radiance;
    radiance.op = Op::Radiance;
    radiance.text = "scene.xml";
    radiance.index = 3;
    radiance.repeats = 1000;
    radiance.seed = 0xfedcba9876543210ULL;
    radiance.values.assign(6, 1.5F);
    group.requests = {warp, radiance, Request{}};
    return group;
}

/// Decodes a copy on the heap of exactly this size, so that a sanitizer sees every read beyond it.
RequestGroup decodeExactly(const std::string &bytes) {
    const auto copy = std::make_unique<char[]>(bytes.size());
    std::memcpy(copy.get(), bytes.data(), bytes.size());
    return decode(copy.get(), bytes.size());
}

/// True if decode() accepts; fails the test if it throws anything but what it may.
bool accepts(const std::string &bytes) {
    try {
        // What is accepted is what encode() writes, so it must give the same bytes again.
        EXPECT_EQ(encode(decodeExactly(bytes)), bytes);
        return true;
    } catch (const std::runtime_error &) {
        return false;
    }
}

TEST(Encoding, GivesBackEveryField) {
    const RequestGroup group = sampleGroup();
    const RequestGroup back = decodeExactly(encode(group));
    ASSERT_EQ(back.files.size(), group.files.size());
    for (std::size_t i = 0; i < group.files.size(); ++i) {
        EXPECT_EQ(back.files[i].name, group.files[i].name);
        EXPECT_EQ(back.files[i].bytes, group.files[i].bytes);
    }
    ASSERT_EQ(back.requests.size(), group.requests.size());
    for (std::size_t i = 0; i < group.requests.size(); ++i) {
        const Request &want = group.requests[i];
        const Request &got = back.requests[i];
        EXPECT_EQ(got.op, want.op);
        EXPECT_EQ(got.text, want.text);
        EXPECT_EQ(got.index, want.index);
        EXPECT_EQ(got.repeats, want.repeats);
        EXPECT_EQ(got.seed, want.seed);
        EXPECT_EQ(got.parameter, want.parameter);
        ASSERT_EQ(got.values.size(), want.values.size());
        // By bits: NaN and -0 are inputs like any other.
        if (!want.values.empty()) {
            EXPECT_EQ(std::memcmp(got.values.data(), want.values.data(),
                                  want.values.size() * sizeof(float)),
                      0);
        }
    }
}

TEST(Encoding, GivesBackAnEmptyGroup) {
    const RequestGroup back = decodeExactly(encode({}));
    EXPECT_TRUE(back.files.empty());
    EXPECT_TRUE(back.requests.empty());
}

TEST(Encoding, RefusesAMessageCutAnywhere) {
    const std::string bytes = encode(sampleGroup());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(accepts(bytes.substr(0, size))) << "cut to " << size << " bytes";
}

TEST(Encoding, RefusesBytesAfterTheEnd) {
    EXPECT_FALSE(accepts(encode(sampleGroup()) + '\0'));
}

TEST(Encoding, RefusesAnotherMagicOrVersion) {
    const std::string bytes = encode(sampleGroup());
    for (const std::size_t at : {std::size_t{0}, std::size_t{4}}) {
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] + 1);
        EXPECT_FALSE(accepts(changed)) << "byte " << at;
    }
}

TEST(Encoding, RefusesAnUnknownOp) {
    RequestGroup group;
    group.requests.resize(1);
    const std::uint32_t last = static_cast<std::uint32_t>(Op::Film);
    for (const std::uint32_t op : {0U, last + 1, 0xffffffffU}) {
        group.requests[0].op = static_cast<Op>(op);
        EXPECT_FALSE(accepts(encode(group))) << op;
    }
}

TEST(Encoding, AllocatesInProportionToTheMessageWhateverItsCountsSay) {
    const std::string bytes = encode(sampleGroup());
    // In memory a file or request takes at most this many times its smallest encoding.
    const std::size_t bound = 16 * bytes.size();
    for (std::size_t at = 0; at + 4 <= bytes.size(); ++at) {
        for (const std::uint32_t count : {0xffffffffU, 0x7fffffffU, 0x40000000U, 0x00010000U}) {
            std::string changed = bytes;
            std::memcpy(&changed[at], &count, sizeof count);
            largestAllocation = 0;
            try {
                decode(changed.data(), changed.size());
            } catch (const std::runtime_error &) {
            }
            ASSERT_LE(largestAllocation, bound) << "count " << count << " at byte " << at;
        }
    }
}

TEST(Encoding, SurvivesRandomDamage) {
    const std::string bytes = encode(sampleGroup());
    std::mt19937 random(1);
    int accepted = 0;
    constexpr int kTrials = 20000;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::string changed = bytes;
        const auto flips = 1 + random() % 4;
        for (std::uint32_t i = 0; i < flips; ++i)
            changed[random() % changed.size()] ^= static_cast<char>(1U << random() % 8);
        accepted += accepts(changed) ? 1 : 0;
    }
    // Damage to contents is not seen, damage to the structure is: both must have happened.
    EXPECT_GT(accepted, kTrials / 100);
    EXPECT_LT(accepted, kTrials);
}

TEST(Encoding, SurvivesNoise) {
    std::mt19937 random(2);
    const std::string start = encode({}).substr(0, 8);
    for (int trial = 0; trial < 20000; ++trial) {
        std::string noise = start;
        for (auto left = random() % 200; left > 0; --left)
            noise += static_cast<char>(random() % 4 == 0 ? random() : 0);
        accepts(noise);
    }
}

} // namespace
} // namespace protocol
