// SPDX-License-Identifier: MIT
#include <nori/bsdf.h>
#include <nori/emitter.h>
#include <nori/mesh.h>
#include <nori/warp.h>

#include <Eigen/Geometry>

NORI_NAMESPACE_BEGIN

Mesh::Mesh() = default;

Mesh::~Mesh() {
    delete m_bsdf;
    delete m_emitter;
}

void Mesh::activate() {
    if (m_bsdf == nullptr) {
        m_bsdf = static_cast<BSDF *>(NoriObjectFactory::createInstance("diffuse", PropertyList()));
        m_bsdf->activate();
    }
    m_pdf.reserve(getTriangleCount());
    // graded: begin
    for (n_UINT i = 0; i < getTriangleCount(); ++i)
        m_pdf.append(surfaceArea(i));
    m_pdf.normalize();
    if (m_emitter != nullptr && !m_pdf.isNormalized())
        throw NoriException("Mesh \"%s\" is an emitter, but has no area!", m_name);
    // graded: end
}

float Mesh::surfaceArea(n_UINT index) const {
    const Point3f p0 = m_V.col(m_F(0, index));
    const Point3f p1 = m_V.col(m_F(1, index));
    const Point3f p2 = m_V.col(m_F(2, index));
    return 0.5f * (p1 - p0).cross(p2 - p0).norm();
}

bool Mesh::rayIntersect(n_UINT index, const Ray3f &ray, float &u, float &v, float &t) const {
    const Point3f p0 = m_V.col(m_F(0, index));
    const Vector3f edge1 = m_V.col(m_F(1, index)) - p0;
    const Vector3f edge2 = m_V.col(m_F(2, index)) - p0;

    const Vector3f pvec = ray.d.cross(edge2);
    const float determinant = edge1.dot(pvec);
    if (determinant > -1e-8f && determinant < 1e-8f)
        return false; // parallel to the triangle
    const float inverse = 1.0f / determinant;

    const Vector3f tvec = ray.o - p0;
    u = tvec.dot(pvec) * inverse;
    if (u < 0.0f || u > 1.0f)
        return false;

    const Vector3f qvec = tvec.cross(edge1);
    v = ray.d.dot(qvec) * inverse;
    if (v < 0.0f || u + v > 1.0f)
        return false;

    t = edge2.dot(qvec) * inverse;
    return t >= ray.mint && t <= ray.maxt;
}

BoundingBox3f Mesh::getBoundingBox(n_UINT index) const {
    BoundingBox3f result(m_V.col(m_F(0, index)));
    result.expandBy(m_V.col(m_F(1, index)));
    result.expandBy(m_V.col(m_F(2, index)));
    return result;
}

Point3f Mesh::getCentroid(n_UINT index) const {
    return (m_V.col(m_F(0, index)) + m_V.col(m_F(1, index)) + m_V.col(m_F(2, index))) / 3.0f;
}

void Mesh::samplePosition(const Point2f &sample, Point3f &p, Normal3f &n, Point2f &uv) const {
    // graded: begin Mesh::samplePosition() is not yet implemented!
    // u = 0 would be given to the first face even if that has no area
    float u = std::max(sample.x(), std::numeric_limits<float>::min());
    const auto face = static_cast<n_UINT>(m_pdf.sampleReuse(u));
    const Point2f barycentric = Warp::squareToUniformTriangle(Point2f(u, sample.y()));
    const Vector3f weights(1.0f - barycentric.x() - barycentric.y(), barycentric.x(),
                           barycentric.y());

    const n_UINT i0 = m_F(0, face);
    const n_UINT i1 = m_F(1, face);
    const n_UINT i2 = m_F(2, face);
    const auto interpolate = [&](const MatrixXf &attribute) {
        return (weights[0] * attribute.col(i0) + weights[1] * attribute.col(i1) +
                weights[2] * attribute.col(i2))
            .eval();
    };
    p = interpolate(m_V);
    if (m_UV.size() > 0)
        uv = interpolate(m_UV);

    n = Normal3f(0.0f);
    if (m_N.size() > 0)
        n = interpolate(m_N);
    if (n.squaredNorm() == 0.0f) { // no normals, or opposite ones
        const Point3f p0 = m_V.col(i0);
        const Point3f p1 = m_V.col(i1);
        const Point3f p2 = m_V.col(i2);
        n = (p1 - p0).cross(p2 - p0);
    }
    n.normalize();
    // graded: end
}

float Mesh::pdf(const Point3f &p) const {
    // graded: begin Mesh::pdf() is not yet implemented!
    (void)p; // uniform
    return m_pdf.getNormalization();
    // graded: end
}

void Mesh::addChild(NoriObject *child, const std::string &) {
    switch (child->getClassType()) {
    case EBSDF:
        if (m_bsdf != nullptr)
            throw NoriException("Mesh: tried to register multiple BSDF instances!");
        m_bsdf = static_cast<BSDF *>(child);
        break;
    case EEmitter:
        if (m_emitter != nullptr)
            throw NoriException("Mesh: tried to register multiple Emitter instances!");
        m_emitter = static_cast<Emitter *>(child);
        break;
    default:
        throw NoriException("Mesh::addChild(<%s>) is not supported!",
                            classTypeName(child->getClassType()));
    }
}

std::string Mesh::toString() const {
    return tfm::format("Mesh[\n"
                       "  name = \"%s\",\n"
                       "  vertexCount = %i,\n"
                       "  triangleCount = %i,\n"
                       "  bsdf = %s,\n"
                       "  emitter = %s\n"
                       "]",
                       m_name, getVertexCount(), getTriangleCount(),
                       m_bsdf != nullptr ? indent(m_bsdf->toString()) : "null",
                       m_emitter != nullptr ? indent(m_emitter->toString()) : "null");
}

std::string Intersection::toString() const {
    if (mesh == nullptr)
        return "Intersection[invalid]";
    return tfm::format("Intersection[\n"
                       "  p = %s,\n"
                       "  t = %f,\n"
                       "  uv = %s,\n"
                       "  shFrame = %s,\n"
                       "  geoFrame = %s,\n"
                       "  mesh = %s\n"
                       "]",
                       p.toString(), t, uv.toString(), indent(shFrame.toString()),
                       indent(geoFrame.toString()), indent(mesh->toString()));
}

NORI_NAMESPACE_END
