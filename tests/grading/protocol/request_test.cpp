// SPDX-License-Identifier: MIT
#include <catalog/warp_catalog.h>
#include <protocol/request.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace protocol {
namespace {

Request requestOf(Op op, std::size_t floats, const std::string &text = "scene.xml") {
    Request request;
    request.op = op;
    request.text = text;
    request.values.assign(floats, 0.5F);
    return request;
}

TEST(WarpDimension, IsTheOneOfTheCatalogueForEveryWarp) {
    for (const catalog::WarpEntry &entry : catalog::warpCatalog()) {
        const std::uint32_t dimension = warpDimension(std::string(entry.id));
        EXPECT_EQ(dimension, static_cast<std::uint32_t>(entry.dimension)) << entry.id;
    }
}

TEST(WarpDimension, RefusesAnUnknownWarpAndNamesIt) {
    try {
        warpDimension("uniform_disk");
        FAIL() << "accepted";
    } catch (const std::invalid_argument &error) {
        EXPECT_NE(std::string(error.what()).find("uniform_disk"), std::string::npos);
    }
}

TEST(ResultSize, CountsTheFloatsOfEveryAnswer) {
    EXPECT_EQ(requestOf(Op::WarpSample, 10, "disk").resultSize(), 10U);
    EXPECT_EQ(requestOf(Op::WarpSample, 10, "sphere").resultSize(), 15U);
    EXPECT_EQ(requestOf(Op::WarpDensity, 10, "triangle").resultSize(), 5U);
    EXPECT_EQ(requestOf(Op::WarpDensity, 15, "beckmann").resultSize(), 5U);
    EXPECT_EQ(requestOf(Op::MeshSample, 10).resultSize(), 40U);
    EXPECT_EQ(requestOf(Op::MeshDensity, 15).resultSize(), 5U);
    EXPECT_EQ(requestOf(Op::EmitterSample, 30).resultSize(), 105U);
    EXPECT_EQ(requestOf(Op::EmitterEval, 55).resultSize(), 20U);
    EXPECT_EQ(requestOf(Op::EmitterPick, 5).resultSize(), 15U);
    EXPECT_EQ(requestOf(Op::SceneFacts, 0).resultSize(), 5U);
    Request radiance = requestOf(Op::Radiance, 30);
    radiance.repeats = 7;
    EXPECT_EQ(radiance.resultSize(), 105U);
}

TEST(ResultSize, IsZeroWithoutInputs) {
    for (const Op op : {Op::MeshSample, Op::MeshDensity, Op::EmitterSample, Op::EmitterEval,
                        Op::EmitterPick, Op::Radiance})
        EXPECT_EQ(requestOf(op, 0).resultSize(), 0U) << static_cast<int>(op);
    EXPECT_EQ(requestOf(Op::WarpSample, 0, "square").resultSize(), 0U);
}

TEST(ResultSize, RefusesIncompleteRows) {
    EXPECT_THROW(requestOf(Op::WarpSample, 3, "disk").resultSize(), std::invalid_argument);
    EXPECT_THROW(requestOf(Op::WarpDensity, 4, "sphere").resultSize(), std::invalid_argument);
    EXPECT_THROW(requestOf(Op::MeshSample, 5).resultSize(), std::invalid_argument);
    EXPECT_THROW(requestOf(Op::MeshDensity, 5).resultSize(), std::invalid_argument);
    EXPECT_THROW(requestOf(Op::EmitterSample, 7).resultSize(), std::invalid_argument);
    EXPECT_THROW(requestOf(Op::EmitterEval, 12).resultSize(), std::invalid_argument);
    EXPECT_THROW(requestOf(Op::Radiance, 7).resultSize(), std::invalid_argument);
}

TEST(ResultSize, RefusesAnAnswerBeyondFourBillionFloats) {
    Request request = requestOf(Op::Radiance, 12);
    request.repeats = 0xffffffff;
    EXPECT_THROW(request.resultSize(), std::invalid_argument);
}

TEST(ResultSize, RefusesAnUnknownOp) {
    EXPECT_THROW(requestOf(static_cast<Op>(99), 6).resultSize(), std::invalid_argument);
}

} // namespace
} // namespace protocol
