// SPDX-License-Identifier: MIT
#include <catalog/warp_catalog.h>
#include <grader/report/point_picture.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace grader {
namespace {

using battery::Input;
using battery::Output;

std::size_t count(const std::string &text, const std::string &part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

std::string pictures(const char *warp, const std::vector<Output> &outputs) {
    return pointPictures(catalog::requireWarp(warp),
                         std::vector<Input>(outputs.size(), {0.25F, 0.75F}), outputs, "halton");
}

TEST(PointPictures, PutYUpwards) {
    const std::string html = pictures("square", {{0.1F, 0.2F, 0.0F}});
    EXPECT_NE(html.find("Samples: halton"), std::string::npos);
    EXPECT_NE(html.find("M250 250h0"), std::string::npos) << html;
    EXPECT_NE(html.find("M100 800h0"), std::string::npos) << html;
}

TEST(PointPictures, DrawWhatLooksAwayFainter) {
    const std::string near = pictures("sphere", {{0.0F, 0.0F, 1.0F}});
    const std::string far = pictures("sphere", {{0.0F, 0.0F, -1.0F}});
    // elevation 25 degrees: the poles are cos(25°) off the centre
    const std::string up = "\"M500 65h0\" stroke-opacity=\"0.8\"";
    const std::string down = "\"M500 935h0\" stroke-opacity=\"0.25\"";
    EXPECT_NE(near.find(up), std::string::npos) << near;
    EXPECT_NE(far.find(down), std::string::npos) << far;
}

TEST(PointPictures, ShowAFewThousandAtMost) {
    const std::string html =
        pictures("square", std::vector<Output>(100000, Output{0.5F, 0.5F, 0.0F}));
    EXPECT_LE(count(html, "h0"), 6000U);
    EXPECT_GT(count(html, "h0"), 4000U);
}

TEST(PointPictures, LeaveOutWhatIsNoPoint) {
    EXPECT_EQ(
        count(pictures("disk", {{NAN, 0.0F, 0.0F}, {INFINITY, 0.0F, 0.0F}, {1e9F, 0.0F, 0.0F}}),
              "h0"),
        3U)
        << "the three inputs alone";
    EXPECT_EQ(count(pictures("sphere", {{NAN, NAN, NAN}}), "h0"), 1U);
}

} // namespace
} // namespace grader
