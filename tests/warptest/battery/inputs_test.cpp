// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

using battery::Input;
using battery::Output;

namespace {

bool isInContract(const Input &input) {
    return battery::isWithinContract(input);
}

Output asOutput(const Input &input) {
    return {input.u, input.v, 0.0F};
}

} // namespace

TEST(EdgeInputs, HoldTheCornersAndExactlyOneOnlyBeyondTheContract) {
    const auto inputs = battery::edgeInputs();
    EXPECT_EQ(inputs.size(), 169U);
    EXPECT_EQ(std::count_if(inputs.begin(), inputs.end(), isInContract), 144);
    EXPECT_FALSE(battery::isWithinContract({1.0F, 0.5F}));
    std::set<std::pair<float, float>> different;
    for (const Input &input : inputs) {
        different.insert({input.u, input.v});
    }
    EXPECT_EQ(different.size(), 169U);
}

TEST(RandomInputs, AreReproducibleAndWithinTheContract) {
    const auto inputs = battery::randomInputs(1000, 5);
    const auto again = battery::randomInputs(1000, 5);
    EXPECT_TRUE(std::all_of(inputs.begin(), inputs.end(), isInContract));
    EXPECT_EQ(inputs[999].v, again[999].v);
    EXPECT_NE(inputs[999].v, battery::randomInputs(1000, 6)[999].v);
    EXPECT_TRUE(battery::randomInputs(0, 5).empty());
}

TEST(StratifiedInputs, FillEveryCellOnce) {
    constexpr int kSide = 64;
    std::set<std::pair<int, int>> cells;
    for (const Input &input : battery::stratifiedInputs(kSide, 5)) {
        EXPECT_TRUE(battery::isWithinContract(input));
        cells.insert({static_cast<int>(input.u * kSide), static_cast<int>(input.v * kSide)});
    }
    EXPECT_EQ(cells.size(), 4096U);
}

TEST(GridInputs, AreCellCentres) {
    const auto inputs = battery::gridInputs(2);
    ASSERT_EQ(inputs.size(), 4U);
    EXPECT_EQ(inputs[1].u, 0.25F);
    EXPECT_EQ(inputs[1].v, 0.75F);
}

TEST(HideDuplicates, KeepsEveryInputAndItsCopies) {
    const auto inputs = battery::randomInputs(500, 1);
    const auto batch = battery::hideDuplicates(inputs, 100, 2);
    ASSERT_EQ(batch.inputs.size(), 600U);
    ASSERT_EQ(batch.pairs.size(), 100U);
    for (const auto &pair : batch.pairs) {
        EXPECT_NE(pair.first, pair.second);
        EXPECT_EQ(batch.inputs[pair.first].u, batch.inputs[pair.second].u);
    }
    std::vector<Output> outputs;
    std::transform(batch.inputs.begin(), batch.inputs.end(), std::back_inserter(outputs), asOutput);
    const auto kept = battery::withoutDuplicates(batch, outputs);
    std::multiset<std::pair<float, float>> expected;
    std::multiset<std::pair<float, float>> got;
    for (const Input &input : inputs) {
        expected.insert({input.u, input.v});
    }
    for (const Output &output : kept) {
        got.insert({output.x, output.y});
    }
    EXPECT_EQ(got, expected);
    EXPECT_TRUE(battery::hideDuplicates({}, 10, 1).inputs.empty());
}

TEST(JudgeDuplicates, FindsAWarpWithItsOwnRandomNumbers) {
    const auto batch = battery::hideDuplicates(battery::randomInputs(500, 1), 100, 2);
    std::vector<Output> right;
    std::vector<Output> wrong;
    statistics::Random own(3);
    for (const Input &input : batch.inputs) {
        right.push_back(asOutput(input));
        wrong.push_back({own.nextFloat(), own.nextFloat(), 0.0F});
    }
    EXPECT_EQ(battery::judgeDuplicates(batch, right).differing, 0U);
    EXPECT_EQ(battery::judgeDuplicates(batch, wrong).differing, 100U);
    EXPECT_THROW(battery::judgeDuplicates(batch, {}), std::invalid_argument);
    EXPECT_THROW(battery::withoutDuplicates(batch, {}), std::invalid_argument);
}
