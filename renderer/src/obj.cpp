// SPDX-License-Identifier: MIT
#include <nori/mesh.h>
#include <nori/scene_text.h>

#include <Eigen/Geometry>
#include <filesystem/resolver.h>

#include <array>
#include <sstream>
#include <tuple>
#include <unordered_map>

NORI_NAMESPACE_BEGIN

namespace {

constexpr uint32_t kNone = 0xffffffffu;

/// `p`, `p/t`, `p//n` or `p/t/n` of a face, counted from 0.
struct Corner {
    uint32_t p = kNone;
    uint32_t t = kNone;
    uint32_t n = kNone;

    bool operator==(const Corner &other) const {
        return p == other.p && t == other.t && n == other.n;
    }
};

struct CornerHash {
    size_t operator()(const Corner &corner) const {
        const std::hash<uint64_t> hash;
        return hash((static_cast<uint64_t>(corner.p) << 32 | corner.t) * 0x9e3779b97f4a7c15ull +
                    corner.n);
    }
};

/// Reads Wavefront OBJ line by line; what it throws names the line.
class ObjReader {
public:
    ObjReader(const std::string &fileName, const Transform &toWorld)
        : m_text(fileName), m_toWorld(toWorld) {
        std::istringstream stream(m_text.bytes());
        for (std::string line; std::getline(stream, line);) {
            ++m_line;
            parseLine(line);
        }
        if (faces.empty() && m_degenerate > 0)
            throw NoriException("%s: all %d triangles are degenerate", fileName, m_degenerate);
        if (faces.empty())
            throw NoriException("%s: holds no triangle", fileName);
        if (m_degenerate > 0)
            cerr << "Warning: " << fileName << ":" << m_firstDegenerate << ": " << m_degenerate
                 << " degenerate triangle(s) left out" << endl;
    }

    std::vector<Point3f> positions;
    std::vector<Point2f> uvs;
    std::vector<Normal3f> normals;
    std::vector<Corner> corners; ///< distinct ones: the mesh's vertices
    std::vector<uint32_t> faces; ///< three corners each
    BoundingBox3f bbox;          ///< of all positions, used or not, as in Nori 2

private:
    [[noreturn]] void fail(const std::string &message) const {
        throw NoriException("%s:%d: %s", m_text.name(), m_line, message);
    }

    float readNumber(std::istringstream &stream, const char *what) const {
        std::string token;
        if (!(stream >> token))
            fail(std::string("a coordinate of ") + what + " is missing");
        char *end = nullptr;
        const float value = strtof(token.c_str(), &end);
        if (*end != '\0')
            fail("\"" + token + "\" is no number");
        if (!std::isfinite(value))
            fail(std::string("a coordinate of ") + what + " is not finite: " + token);
        return value;
    }

    void requireFinite(const Eigen::Vector3f &v, const char *what) const {
        if (!v.allFinite())
            fail(std::string("the ") + what + " is not finite after toWorld");
    }

    void parseLine(const std::string &line) {
        std::istringstream stream(line);
        std::string tag;
        stream >> tag;
        if (tag == "v") {
            const float x = readNumber(stream, "a vertex");
            const float y = readNumber(stream, "a vertex");
            const float z = readNumber(stream, "a vertex");
            positions.push_back(m_toWorld * Point3f(x, y, z));
            requireFinite(positions.back(), "vertex");
            bbox.expandBy(positions.back());
        } else if (tag == "vt") {
            const float u = readNumber(stream, "a texture coordinate");
            const float v = readNumber(stream, "a texture coordinate");
            uvs.emplace_back(u, v);
        } else if (tag == "vn") {
            const float x = readNumber(stream, "a normal");
            const float y = readNumber(stream, "a normal");
            const float z = readNumber(stream, "a normal");
            normals.emplace_back((m_toWorld * Normal3f(x, y, z)).normalized());
            requireFinite(normals.back(), "normal");
        } else if (tag == "f") {
            parseFace(stream);
        }
    }

    uint32_t parseIndex(const std::string &token, size_t count, const char *what) const {
        char *end = nullptr;
        const long number = strtol(token.c_str(), &end, 10);
        if (token.empty() || *end != '\0')
            fail("\"" + token + "\" is no index of a " + what);
        // Negative ones count back from the last.
        const long index = number < 0 ? static_cast<long>(count) + number : number - 1;
        if (index < 0 || index >= static_cast<long>(count))
            fail("the " + std::string(what) + " " + token + " does not exist; there are " +
                 std::to_string(count) + " so far");
        return static_cast<uint32_t>(index);
    }

    Corner parseCorner(const std::string &token) const {
        const std::vector<std::string> parts = tokenize(token, "/", true);
        if (parts.empty() || parts.size() > 3)
            fail("\"" + token + "\" is no corner of a face; known: p, p/t, p//n, p/t/n");
        Corner corner;
        corner.p = parseIndex(parts[0], positions.size(), "vertex");
        if (parts.size() > 1 && !parts[1].empty())
            corner.t = parseIndex(parts[1], uvs.size(), "texture coordinate");
        if (parts.size() > 2 && !parts[2].empty())
            corner.n = parseIndex(parts[2], normals.size(), "normal");
        return corner;
    }

    void parseFace(std::istringstream &stream) {
        std::vector<Corner> polygon;
        for (std::string token; stream >> token;)
            polygon.push_back(parseCorner(token));
        if (polygon.size() < 3)
            fail("a face of fewer than three corners");
        // Quads as Nori 2 splits them: 0-1-2 and 3-0-2; more corners as the fan that continues it.
        addTriangle(polygon[0], polygon[1], polygon[2]);
        for (size_t i = 3; i < polygon.size(); ++i)
            addTriangle(polygon[i], polygon[0], polygon[i - 1]);
    }

    void addTriangle(const Corner &a, const Corner &b, const Corner &c) {
        const Point3f &p = positions[a.p];
        const Vector3f ab = positions[b.p] - p;
        const Vector3f ac = positions[c.p] - p;
        if (!(ab.cross(ac).squaredNorm() > 0)) {
            m_firstDegenerate = m_degenerate == 0 ? m_line : m_firstDegenerate;
            ++m_degenerate;
            return;
        }
        for (const Corner &corner : {a, b, c}) {
            const auto found = m_vertices.emplace(corner, static_cast<uint32_t>(corners.size()));
            if (found.second) {
                corners.push_back(corner);
                m_cornerLines.push_back(m_line);
            }
            faces.push_back(found.first->second);
        }
    }

    SceneText m_text;
    Transform m_toWorld;
    int m_line = 0;
    int m_degenerate = 0;
    int m_firstDegenerate = 0;
    std::unordered_map<Corner, uint32_t, CornerHash> m_vertices;
    std::vector<int> m_cornerLines;

public:
    /// `file:line` of the first face with corner `index`.
    std::string placeOf(size_t index) const {
        return m_text.name() + ":" + std::to_string(m_cornerLines[index]);
    }
};

} // namespace

/// Mesh from a Wavefront OBJ file. Materials, groups and smoothing are ignored.
class WavefrontOBJ : public Mesh {
public:
    WavefrontOBJ(const PropertyList &properties) {
        const std::string name = properties.getString("filename");
        if (name.empty())
            throw NoriException("Property 'filename' is empty!");
        const Transform toWorld = properties.getTransform("toWorld", Transform());
        const std::string fileName = getFileResolver()->resolve(filesystem::path(name)).str();
        const ObjReader obj(fileName, toWorld);

        m_name = fileName;
        m_bbox = obj.bbox;
        const auto count = static_cast<Eigen::Index>(obj.corners.size());
        m_F.resize(3, static_cast<Eigen::Index>(obj.faces.size() / 3));
        std::copy(obj.faces.begin(), obj.faces.end(), m_F.data());
        m_V.resize(3, count);
        if (!obj.normals.empty())
            m_N.resize(3, count);
        if (!obj.uvs.empty())
            m_UV.resize(2, count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto index = static_cast<size_t>(i);
            const Corner &corner = obj.corners[index];
            m_V.col(i) = obj.positions[corner.p];
            if (!obj.normals.empty())
                m_N.col(i) = obj.normals.at(require(obj, index, corner.n, "normal"));
            if (!obj.uvs.empty())
                m_UV.col(i) = obj.uvs.at(require(obj, index, corner.t, "texture coordinate"));
        }
    }

private:
    /// If the file has any normal (texture coordinate), every corner must name one.
    static uint32_t require(const ObjReader &obj, size_t corner, uint32_t index, const char *what) {
        if (index == kNone)
            throw NoriException("%s: a corner without %s, although the file has some",
                                obj.placeOf(corner), what);
        return index;
    }
};

NORI_REGISTER_CLASS(WavefrontOBJ, "obj")

NORI_NAMESPACE_END
