// SPDX-License-Identifier: MIT
#include <nori/accel.h>
#include <nori/emitter.h>
#include <nori/mesh.h>

#include <Eigen/Geometry>
#include <embree3/rtcore.h>

#include <limits>

NORI_NAMESPACE_BEGIN

/// One Embree geometry per mesh, with the mesh's index as its id.
struct Accel::Backend {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = nullptr;

    Backend() {
        if (device == nullptr)
            throw NoriException("Embree cannot be started (error %d)",
                                static_cast<int>(rtcGetDeviceError(nullptr)));
        scene = rtcNewScene(device);
        // Rays that pass exactly through an edge must not leak through.
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    }

    ~Backend() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    Backend(const Backend &) = delete;
    Backend &operator=(const Backend &) = delete;

    void add(const Mesh &mesh, unsigned int id) const {
        const MatrixXf &positions = mesh.getVertexPositions();
        const MatrixXu &faces = mesh.getIndices();
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        void *vertices =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), static_cast<size_t>(positions.cols()));
        void *indices =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(uint32_t), static_cast<size_t>(faces.cols()));
        if (vertices == nullptr || indices == nullptr)
            throw NoriException("%s: not enough memory for the mesh", mesh.getName());
        memcpy(vertices, positions.data(), static_cast<size_t>(positions.size()) * sizeof(float));
        memcpy(indices, faces.data(), static_cast<size_t>(faces.size()) * sizeof(uint32_t));
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, id);
        rtcReleaseGeometry(geometry);
    }
};

namespace {

/// Embree stops the program at a coordinate beyond 1.844e18 or that is no number; the square of a
/// larger one is not finite. Code under test may well ask for such a ray: it hits nothing.
bool isTraceable(const Eigen::Vector3f &v) {
    return (v.array().abs() <= 1e18f).all();
}

/// \param origin  the point of the ray where Embree is to count from: at `start`
RTCRay toEmbree(const Ray3f &ray, const Point3f &origin, float start, float mint) {
    RTCRay result{};
    result.org_x = origin.x();
    result.org_y = origin.y();
    result.org_z = origin.z();
    result.dir_x = ray.d.x();
    result.dir_y = ray.d.y();
    result.dir_z = ray.d.z();
    result.tnear = mint - start;
    result.tfar = ray.maxt - start;
    result.mask = 0xffffffffu;
    return result;
}

/// As Nori's own accelerator does it: the position from the barycentric weights, so that it lies on
/// the triangle whatever the distance.
void fill(const Mesh &mesh, n_UINT face, float u, float v, Intersection &its) {
    const MatrixXf &positions = mesh.getVertexPositions();
    const MatrixXf &normals = mesh.getVertexNormals();
    const MatrixXf &uvs = mesh.getVertexTexCoords();
    const MatrixXu &faces = mesh.getIndices();
    const n_UINT a = faces(0, face);
    const n_UINT b = faces(1, face);
    const n_UINT c = faces(2, face);
    const Vector3f weights(1 - u - v, u, v);

    const Point3f p0 = positions.col(a);
    const Point3f p1 = positions.col(b);
    const Point3f p2 = positions.col(c);
    its.mesh = &mesh;
    its.p = weights.x() * p0 + weights.y() * p1 + weights.z() * p2;
    its.uv = uvs.size() > 0 ? Point2f(weights.x() * uvs.col(a) + weights.y() * uvs.col(b) +
                                      weights.z() * uvs.col(c))
                            : Point2f(u, v);
    its.geoFrame = Frame((p1 - p0).cross(p2 - p0).normalized());
    its.shFrame = its.geoFrame;
    if (normals.size() == 0)
        return;
    const Vector3f normal =
        weights.x() * normals.col(a) + weights.y() * normals.col(b) + weights.z() * normals.col(c);
    if (normal.squaredNorm() > 0) // not where opposite ones meet, or the file has `vn 0 0 0`
        its.shFrame = Frame(normal.normalized());
}

} // namespace

Accel::Accel() : m_backend(new Backend()) {}

Accel::~Accel() {
    for (Mesh *mesh : m_meshes)
        delete mesh;
}

void Accel::addMesh(Mesh *mesh) {
    m_meshes.push_back(mesh);
    m_bbox.expandBy(mesh->getBoundingBox());
}

void Accel::build() {
    for (size_t i = 0; i < m_meshes.size(); ++i)
        m_backend->add(*m_meshes[i], static_cast<unsigned int>(i));
    rtcCommitScene(m_backend->scene);
}

n_UINT Accel::getTriangleCount() const {
    n_UINT count = 0;
    for (const Mesh *mesh : m_meshes)
        count += mesh->getTriangleCount();
    return count;
}

bool Accel::rayIntersect(const Ray3f &ray, Intersection &its, bool shadowRay) const {
    its.t = std::numeric_limits<float>::infinity();
    float mint = ray.mint;
    if (mint == Epsilon)
        mint = std::max(mint, mint * ray.o.array().abs().maxCoeff());
    // Nori takes segments that begin behind the origin; Embree stops the program at one.
    const float start = std::min(mint, 0.0f);
    const Point3f origin = start < 0 ? Point3f(ray.o + start * ray.d) : ray.o;
    if (m_meshes.empty() || !(ray.maxt >= mint) || !isTraceable(origin) || !isTraceable(ray.d))
        return false;

    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    if (shadowRay) {
        RTCRay query = toEmbree(ray, origin, start, mint);
        rtcOccluded1(m_backend->scene, &context, &query);
        return query.tfar < 0;
    }
    RTCRayHit query{};
    query.ray = toEmbree(ray, origin, start, mint);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(m_backend->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    its.t = query.ray.tfar + start;
    fill(*m_meshes[query.hit.geomID], query.hit.primID, query.hit.u, query.hit.v, its);
    return true;
}

NORI_NAMESPACE_END
