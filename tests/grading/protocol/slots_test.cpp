// SPDX-License-Identifier: MIT
#include <protocol/request.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace protocol {
namespace {

constexpr std::size_t kMaxMessage = 2000;

/// Three requests and the memory for their answers.
class Slots : public testing::Test {
protected:
    Slots() {
        for (const std::size_t floats : {2U, 200U, 0U}) {
            Request request;
            request.op = Op::WarpSample;
            request.text = "sphere";
            request.values.assign(floats, 0.5F);
            m_group.requests.push_back(request);
        }
        m_layout = slotLayout(m_group);
        m_memory.assign(m_layout.size, 'x');
        clearSlots(m_layout, m_memory.data());
    }

    Response read(std::size_t request) const {
        return readSlot(m_layout, m_group, request, m_memory.data());
    }

    void write(std::size_t request, const Response &response) {
        writeSlot(m_layout, request, response, m_memory.data());
    }

    template <typename T>
    void overwrite(std::size_t request, std::size_t at, T value) {
        std::memcpy(&m_memory[m_layout.offsets[request] + at], &value, sizeof value);
    }

    RequestGroup m_group;
    SlotLayout m_layout;
    std::string m_memory;
};

Response done(std::size_t floats) {
    Response response;
    response.state = State::Done;
    response.cpuSeconds = 0.25;
    for (std::size_t i = 0; i < floats; ++i)
        response.values.push_back(static_cast<float>(i));
    return response;
}

TEST_F(Slots, DoNotOverlapAndAreAligned) {
    ASSERT_EQ(m_layout.offsets.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(m_layout.offsets[i] % 64, 0U);
        const std::size_t end = i + 1 < 3 ? m_layout.offsets[i + 1] : m_layout.size;
        EXPECT_GE(end - m_layout.offsets[i],
                  kMaxMessage + m_group.requests[i].resultSize() * sizeof(float));
    }
}

TEST_F(Slots, ArePendingAndNaNAfterClearing) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(read(i).state, State::Pending);
        EXPECT_TRUE(read(i).values.empty());
    }
    // A slot whose state alone is forged holds no zeros to be mistaken for answers.
    overwrite(1, 0, State::Done);
    for (const float value : read(1).values)
        EXPECT_TRUE(std::isnan(value));
}

TEST_F(Slots, GiveBackAnAnswerAndLeaveTheOthersAlone) {
    write(1, done(300));
    const Response back = read(1);
    EXPECT_EQ(back.state, State::Done);
    EXPECT_EQ(back.values, done(300).values);
    EXPECT_EQ(back.cpuSeconds, 0.25);
    EXPECT_TRUE(back.message.empty());
    EXPECT_EQ(read(0).state, State::Pending);
    EXPECT_EQ(read(2).state, State::Pending);
}

TEST_F(Slots, GiveBackAnEmptyAnswer) {
    write(2, done(0));
    EXPECT_EQ(read(2).state, State::Done);
    EXPECT_TRUE(read(2).values.empty());
}

TEST_F(Slots, GiveBackAMessageWithoutValues) {
    Response threw;
    threw.state = State::Threw;
    threw.message = "no implementado todav\xc3\xad"
                    "a";
    write(0, threw);
    EXPECT_EQ(read(0).state, State::Threw);
    EXPECT_EQ(read(0).message, threw.message);
    EXPECT_TRUE(read(0).values.empty());
}

TEST_F(Slots, CapTheMessage) {
    Response threw;
    threw.state = State::Threw;
    threw.message.assign(1000000, 'm');
    write(0, threw);
    EXPECT_EQ(read(0).message, std::string(kMaxMessage, 'm'));
    EXPECT_EQ(read(1).state, State::Pending);
}

TEST_F(Slots, ReadAsPendingWhenTheStateIsUnknown) {
    write(0, done(3));
    for (const std::uint32_t state : {0U, 3U, 0xffffffffU}) {
        overwrite(0, 0, state);
        EXPECT_EQ(read(0).state, State::Pending) << state;
        EXPECT_TRUE(read(0).values.empty());
    }
}

TEST_F(Slots, ReadAsPendingWhenTheMessageWouldLeaveTheSlot) {
    write(0, done(3));
    for (const std::uint32_t size : {2001U, 0x80000000U, 0xffffffffU}) {
        overwrite(0, 4, size);
        EXPECT_EQ(read(0).state, State::Pending) << size;
    }
}

TEST_F(Slots, ReadNoTimeThatIsNone) {
    for (const double seconds :
         {-1.0, std::numeric_limits<double>::infinity(), std::nan(""), -HUGE_VAL}) {
        Response response = done(3);
        response.cpuSeconds = seconds;
        write(0, response);
        EXPECT_EQ(read(0).state, State::Done);
        EXPECT_EQ(read(0).cpuSeconds, 0.0);
    }
}

TEST_F(Slots, ReadWithinTheirShapeWhateverTheMemoryHolds) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 20000; ++trial) {
        for (std::size_t i = 0; i < 3; ++i) {
            overwrite(i, 0, static_cast<std::uint32_t>(random() % 4));
            overwrite(i, 4,
                      static_cast<std::uint32_t>(random() % 4 == 0 ? random() : random() % 2100));
            overwrite(i, 8, (std::uint64_t{random()} << 32) | random());
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const Response back = read(i);
            ASSERT_LE(back.message.size(), kMaxMessage);
            ASSERT_TRUE(std::isfinite(back.cpuSeconds) && back.cpuSeconds >= 0);
            ASSERT_EQ(back.values.size(),
                      back.state == State::Done ? m_group.requests[i].resultSize() : 0);
        }
    }
}

TEST(SlotLayout, OfAnEmptyGroupIsEmpty) {
    const SlotLayout layout = slotLayout({});
    EXPECT_TRUE(layout.offsets.empty());
    EXPECT_EQ(layout.size, 0U);
}

} // namespace
} // namespace protocol
