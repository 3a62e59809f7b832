// SPDX-License-Identifier: MIT
#include <grader/build/header_set.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

HeaderSet someHeaders() {
    return overlayHeaders({{"nori/common.h", ""},
                           {"nori/mesh.h", "#include <nori/common.h>\n"},
                           {"nori/emitter.h", "#include <nori/mesh.h>\n"},
                           {"pcg32.h", ""}},
                          {{"emitter.h", "#include \"helper.h\"\n"}, {"helper.h", ""}});
}

TEST(HeaderSet, LaysSubmittedHeadersOverTheBase) {
    const HeaderSet headers = someHeaders();
    EXPECT_EQ(headers.files.at("nori/emitter.h"), "#include \"helper.h\"\n");
    EXPECT_EQ(headers.files.count("nori/helper.h"), 1u);
    EXPECT_EQ(headers.files.at("nori/mesh.h"), "#include <nori/common.h>\n");
}

TEST(HeaderSet, FollowsIncludesThroughOtherHeaders) {
    const std::set<std::string> reached = includeClosure(
        "#include <nori/emitter.h>\n # include <pcg32.h>\n#include <vector>\n", someHeaders());
    EXPECT_EQ(reached, (std::set<std::string>{"nori/emitter.h", "nori/helper.h", "pcg32.h"}));
}

TEST(HeaderSet, ForwardsWrongCaseAndBackslashes) {
    HeaderSet headers = someHeaders();
    const std::set<std::string> added =
        addForwards("#include <nori/Mesh.h>\n#include <nori\\common.h>\n#include \"nori/mesh.h\"\n"
                    "#include <Vector>\n#include \"../nori/MESH.H\"\n",
                    headers);
    EXPECT_EQ(added, (std::set<std::string>{"nori/Mesh.h", "nori\\common.h"}));
    EXPECT_EQ(headers.forwards.at("nori/Mesh.h"), "nori/mesh.h");
    EXPECT_EQ(includeClosure("#include <nori/Mesh.h>\n", headers),
              (std::set<std::string>{"nori/common.h", "nori/mesh.h"}));
}

TEST(HeaderSet, ForwardsTheFolderInWrongCaseAndTheFirstLineAfterAByteOrderMark) {
    HeaderSet headers = someHeaders();
    const std::set<std::string> added = addForwards(
        "\xEF\xBB\xBF#include <Nori/emitter.h>\n#include \"NORI\\Mesh.h\"\n#include \"Helper.h\"\n"
        "#include \"helper.h\"\n#include <other/mesh.h>\n",
        headers);
    EXPECT_EQ(added, (std::set<std::string>{"Nori/emitter.h", "NORI\\Mesh.h", "Helper.h"}));
    EXPECT_EQ(headers.forwards.at("Nori/emitter.h"), "nori/emitter.h");
    EXPECT_EQ(headers.forwards.at("Helper.h"), "nori/helper.h");
}

TEST(HeaderSet, EndsOnIncludesInACircle) {
    const HeaderSet headers = overlayHeaders(
        {{"nori/a.h", "#include <nori/b.h>\n"}, {"nori/b.h", "#include <nori/a.h>\n"}}, {});
    EXPECT_EQ(includeClosure("#include <nori/a.h>\n", headers).size(), 2u);
}

} // namespace
} // namespace grader
