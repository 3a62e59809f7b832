// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene_file.h"

namespace nori {
namespace {

constexpr char kVertices[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

struct BrokenMesh {
    const char *name;
    std::string text;
    std::vector<std::string> message; ///< parts that the error must have
};

std::ostream &operator<<(std::ostream &stream, const BrokenMesh &mesh) {
    return stream << mesh.text;
}

std::vector<BrokenMesh> brokenMeshes() {
    const std::string v = kVertices; // lines 1 to 4
    return {
        {"Empty", "", {"mesh.obj: holds no triangle"}},
        {"WithoutTriangles", v, {"mesh.obj: holds no triangle"}},
        {"AllDegenerate",
         "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 1 1 2\n",
         {"mesh.obj: all 2 triangles are degenerate"}},
        {"NaNVertex", "v 0 0 0\nv nan 0 0\n", {"mesh.obj:2: ", "vertex is not finite: nan"}},
        {"InfiniteVertex", "v 0 inf 0\n", {"mesh.obj:1: ", "vertex is not finite: inf"}},
        {"HugeVertex", "v 1e60 0 0\n", {"mesh.obj:1: ", "not finite: 1e60"}},
        {"NaNNormal", v + "vn nan 0 0\n", {"mesh.obj:5: ", "normal is not finite: nan"}},
        {"ShortVertex", "v 1 2\n", {"mesh.obj:1: a coordinate of a vertex is missing"}},
        {"NoNumber", "v 1 2 x3\n", {R"(mesh.obj:1: "x3" is no number)"}},
        {"TwoCorners", v + "f 1 2\n", {"mesh.obj:5: a face of fewer than three corners"}},
        {"IndexTooLarge",
         v + "f 1 2 9\n",
         {"mesh.obj:5: the vertex 9 does not exist; there are 4"}},
        {"IndexZero", v + "f 0 1 2\n", {"mesh.obj:5: the vertex 0 does not exist"}},
        {"NegativeTooFar", v + "f -5 1 2\n", {"mesh.obj:5: the vertex -5 does not exist"}},
        {"IndexBeyondLong", v + "f 1 2 99999999999999999999\n", {"mesh.obj:5: the vertex 9999"}},
        {"NoIndex", v + "f 1 2 x\n", {R"(mesh.obj:5: "x" is no index of a vertex)"}},
        {"FourParts", v + "f 1/1/1/1 2 3\n", {"mesh.obj:5: ", "known: p, p/t, p//n, p/t/n"}},
        {"NoSuchUv",
         v + "f 1/1 2/1 3/1\n",
         {"mesh.obj:5: the texture coordinate 1 does not exist"}},
        {"NormalMissing", v + "vn 0 0 1\nf 1//1 2//1 3\n", {"mesh.obj:6: a corner without normal"}},
        {"UvMissing",
         v + "vt 0 0\nf 1/1 2/1 3\n",
         {"mesh.obj:6: a corner without texture coordinate"}},
        {"Binary", std::string("\x7f\x45\x4c\x46\0\1\2", 7), {"mesh.obj: holds no triangle"}},
    };
}

class BrokenMeshTest : public testing::TestWithParam<BrokenMesh> {};

TEST_P(BrokenMeshTest, IsReportedWithItsPlace) {
    const test::SceneFolder folder;
    folder.write("mesh.obj", GetParam().text);
    const std::string message = folder.errorOf(test::sceneWith(test::meshOf("mesh.obj")));
    EXPECT_EQ(message.find(R"(scene.xml:3: <mesh type="obj">: )"), 0u) << message;
    for (const std::string &part : GetParam().message)
        EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks " << part;
}

INSTANTIATE_TEST_SUITE_P(Obj, BrokenMeshTest, testing::ValuesIn(brokenMeshes()),
                         [](const auto &mesh) { return mesh.param.name; });

class Obj : public testing::Test {
protected:
    /// Reads `text` as a mesh; `transform` holds the steps of toWorld.
    const Mesh &load(const std::string &text, const std::string &transform = "") {
        m_folder.write("mesh.obj", text);
        m_mesh = m_folder.load(R"(<mesh type="obj"><string name="filename" value="mesh.obj"/>)"
                               R"(<transform name="toWorld">)" +
                               transform + "</transform></mesh>");
        return static_cast<const Mesh &>(*m_mesh);
    }

private:
    test::SceneFolder m_folder;
    std::unique_ptr<NoriObject> m_mesh;
};

/// Corner `corner` of triangle `face`.
Point3f cornerOf(const Mesh &mesh, n_UINT face, n_UINT corner) {
    return mesh.getVertexPositions().col(mesh.getIndices()(corner, face));
}

TEST_F(Obj, SplitsQuadsAsNoriDoesAndKeepsTheWinding) {
    const Mesh &mesh = load("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    ASSERT_EQ(mesh.getTriangleCount(), 2u);
    EXPECT_EQ(mesh.getVertexCount(), 4u);
    const Point3f expected[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 1, 0}};
    for (n_UINT i = 0; i < 6; ++i)
        EXPECT_EQ(cornerOf(mesh, i / 3, i % 3), expected[i]) << i;
}

TEST_F(Obj, SplitsPentagonsIntoAFan) {
    const Mesh &mesh = load("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv -1 1 0\nf 1 2 3 4 5\n");
    ASSERT_EQ(mesh.getTriangleCount(), 3u);
    float area = 0.0f;
    for (n_UINT i = 0; i < 3; ++i)
        area += mesh.surfaceArea(i);
    EXPECT_FLOAT_EQ(area, 5.0f); // by the shoelace formula
}

TEST_F(Obj, SharesVerticesOfEqualCornersOnly) {
    const std::string text = std::string(kVertices) + "vt 0 0\nvt 1 1\n";
    EXPECT_EQ(load(text + "f 1/1 2/1 3/1\nf 2/1 4/1 3/1\n").getVertexCount(), 4u);
    EXPECT_EQ(load(text + "f 1/1 2/1 3/1\nf 2/2 4/2 3/2\n").getVertexCount(), 6u);
}

TEST_F(Obj, CountsNegativeIndicesFromTheLast) {
    const Mesh &mesh = load(std::string(kVertices) + "f -4 -3 -2\n");
    EXPECT_EQ(cornerOf(mesh, 0, 0), Point3f(0, 0, 0));
    EXPECT_EQ(cornerOf(mesh, 0, 2), Point3f(0, 1, 0));
}

TEST_F(Obj, LeavesDegenerateTrianglesOut) {
    const Mesh &mesh = load(std::string(kVertices) + "f 1 1 2\nf 1 2 3\nf 2 2 2\n");
    EXPECT_EQ(mesh.getTriangleCount(), 1u);
}

TEST_F(Obj, ReadsBlanksForeignLineEndsCommentsAndWhatItIgnores) {
    const Mesh &mesh =
        load("# A\xc3\xb1o\r\nmtllib a.mtl\r\no cubo\r\n  v   0 0 0 1.0\r\nv 1 0 0\r\n"
             "v\t0\t1\t0\r\n\r\nusemtl x\r\ns off\r\ng a b\r\nf 1 2 3 \r\n");
    EXPECT_EQ(mesh.getTriangleCount(), 1u);
    EXPECT_EQ(mesh.getVertexNormals().size(), 0);
    EXPECT_EQ(mesh.getVertexTexCoords().size(), 0);
}

TEST_F(Obj, TransformsPointsAndNormalsAndCoversAllPositions) {
    const Mesh &mesh = load(std::string(kVertices) + "v 9 9 9\nvn 1 1 0\nf 1//1 2//1 3//1\n",
                            R"(<scale value="2 1 1"/><translate value="0 0 5"/>)");
    EXPECT_TRUE(cornerOf(mesh, 0, 1).isApprox(Point3f(2, 0, 5)));
    // by the inverse transpose: (1/2, 1, 0), of length 1
    EXPECT_TRUE(mesh.getVertexNormals().col(0).isApprox(Vector3f(0.5f, 1, 0).normalized()));
    EXPECT_TRUE(mesh.getBoundingBox().max.isApprox(Point3f(18, 9, 14)));
}

TEST_F(Obj, ReadsAFileWithAMarkOfUtf8) {
    EXPECT_EQ(cornerOf(load("\xef\xbb\xbf" + std::string(kVertices) + "f 1 2 3\n"), 0, 0),
              Point3f(0, 0, 0));
}

TEST_F(Obj, RefusesWhatIsNotFiniteAfterItsTransformation) {
    const auto errorOf = [this](const std::string &text, const std::string &transform) {
        try {
            load(text, transform);
        } catch (const NoriException &error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string big = R"(<scale value="1e30 1 1"/>)";
    EXPECT_NE(errorOf("# \nv 1 1 1\n", big + big)
                  .find("mesh.obj:2: the vertex is not finite after toWorld"),
              std::string::npos);
    // flattened: points have a place, normals have none
    const std::string flat = R"(<scale value="1 1 0"/>)";
    EXPECT_EQ(errorOf(std::string(kVertices) + "f 1 2 3\n", flat), "");
    EXPECT_NE(errorOf(std::string(kVertices) + "vn 0 0 1\n", flat)
                  .find("mesh.obj:5: the normal is not finite after toWorld"),
              std::string::npos);
}

TEST_F(Obj, KeepsTheWindingWhenMirrored) {
    const Mesh &mesh = load(std::string(kVertices) + "f 1 2 3\n", R"(<scale value="-1 1 1"/>)");
    EXPECT_EQ(cornerOf(mesh, 0, 1), Point3f(-1, 0, 0)); // so its normal points to -z, as in Nori
}

} // namespace
} // namespace nori
