// SPDX-License-Identifier: MIT
#include <nori/proplist.h>

#include <gtest/gtest.h>

namespace nori {
namespace {

TEST(PropertyList, ReturnsWhatWasSet) {
    PropertyList props;
    props.setBoolean("b", true);
    props.setInteger("i", 3);
    props.setFloat("f", 0.5f);
    props.setString("s", "camión");
    props.setColor("c", Color3f(1, 2, 3));
    props.setPoint("p", Point3f(1, 2, 3));
    props.setVector("v", Vector3f(4, 5, 6));
    props.setTransform("t", Transform());
    EXPECT_TRUE(props.getBoolean("b"));
    EXPECT_EQ(props.getInteger("i", 7), 3);
    EXPECT_EQ(props.getFloat("f"), 0.5f);
    EXPECT_EQ(props.getString("s"), "camión");
    EXPECT_EQ(props.getColor("c").g(), 2.0f);
    EXPECT_EQ(props.getPoint("p").z(), 3.0f);
    EXPECT_EQ(props.getVector("v").x(), 4.0f);
    EXPECT_EQ(props.getTransform("t").getMatrix(), Eigen::Matrix4f::Identity());
}

TEST(PropertyList, GivesTheDefaultOnlyForWhatIsMissing) {
    PropertyList props;
    props.setInteger("radius", 2);
    EXPECT_EQ(props.getFloat("stddev", 0.5f), 0.5f);
    EXPECT_THROW(props.getFloat("stddev"), NoriException);
    // an <integer> is no <float>, whether or not there is a default
    EXPECT_THROW(props.getFloat("radius"), NoriException);
    EXPECT_THROW(props.getFloat("radius", 2.0f), NoriException);
}

TEST(PropertyList, SaysWhichTypeItExpected) {
    PropertyList props;
    props.setInteger("radius", 2);
    try {
        props.getFloat("radius");
        FAIL();
    } catch (const NoriException &error) {
        EXPECT_STREQ(error.what(), "Property 'radius' has the wrong type! (expected <float>, "
                                   "detected <integer>)");
    }
}

TEST(PropertyList, KnowsWhichNamesNobodyHasAskedFor) {
    PropertyList props;
    props.setFloat("fov", 45.0f);
    props.setFloat("fvo", 45.0f);
    EXPECT_EQ(props.unqueried(), (std::vector<std::string>{"fov", "fvo"}));
    props.getFloat("fov", 30.0f);
    props.getInteger("width", 1280);
    EXPECT_EQ(props.unqueried(), std::vector<std::string>{"fvo"});
    EXPECT_EQ(props.queried(), (std::vector<std::string>{"fov", "width"}));
}

} // namespace
} // namespace nori
