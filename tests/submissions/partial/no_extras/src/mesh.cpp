#include <nori/mesh.h>
#include <nori/bbox.h>
#include <nori/bsdf.h>
#include <nori/emitter.h>
#include <nori/warp.h>
#include <Eigen/Geometry>

NORI_NAMESPACE_BEGIN

Mesh::Mesh() { }

Mesh::~Mesh() {
    m_pdf.clear();
    delete m_bsdf;
    delete m_emitter;
}

void Mesh::activate() {
    if (!m_bsdf) {
        // Sin material: difuso por defecto
        m_bsdf = static_cast<BSDF *>(
            NoriObjectFactory::createInstance("diffuse", PropertyList()));
    }

    // Cada triángulo se elige con probabilidad proporcional a su área
    m_pdf.reserve(getTriangleCount());
    for (n_UINT i = 0; i < getTriangleCount(); i++)
        m_pdf.append(surfaceArea(i));
    m_pdf.normalize();
}

float Mesh::surfaceArea(n_UINT index) const {
    n_UINT i0 = m_F(0, index), i1 = m_F(1, index), i2 = m_F(2, index);
    const Point3f p0 = m_V.col(i0), p1 = m_V.col(i1), p2 = m_V.col(i2);
    return 0.5f * Vector3f((p1 - p0).cross(p2 - p0)).norm();
}

bool Mesh::rayIntersect(n_UINT index, const Ray3f &ray, float &u, float &v, float &t) const {
    n_UINT i0 = m_F(0, index), i1 = m_F(1, index), i2 = m_F(2, index);
    const Point3f p0 = m_V.col(i0), p1 = m_V.col(i1), p2 = m_V.col(i2);

    Vector3f edge1 = p1 - p0, edge2 = p2 - p0;
    Vector3f pvec = ray.d.cross(edge2);
    float det = edge1.dot(pvec);
    if (det > -1e-8f && det < 1e-8f)
        return false;
    float inv_det = 1.0f / det;

    Vector3f tvec = ray.o - p0;
    u = tvec.dot(pvec) * inv_det;
    if (u < 0.0 || u > 1.0)
        return false;

    Vector3f qvec = tvec.cross(edge1);
    v = ray.d.dot(qvec) * inv_det;
    if (v < 0.0 || u + v > 1.0)
        return false;

    t = edge2.dot(qvec) * inv_det;
    return t >= ray.mint && t <= ray.maxt;
}

BoundingBox3f Mesh::getBoundingBox(n_UINT index) const {
    BoundingBox3f result(m_V.col(m_F(0, index)));
    result.expandBy(m_V.col(m_F(1, index)));
    result.expandBy(m_V.col(m_F(2, index)));
    return result;
}

Point3f Mesh::getCentroid(n_UINT index) const {
    return (1.0f / 3.0f) *
        (m_V.col(m_F(0, index)) + m_V.col(m_F(1, index)) + m_V.col(m_F(2, index)));
}

void Mesh::samplePosition(const Point2f &sample, Point3f &p, Normal3f &n, Point2f &uv) const {
    // sample.x() sirve para elegir triángulo y, reescalado, para las baricéntricas
    float s = sample.x();
    size_t tri = m_pdf.sampleReuse(s);
    Point2f b = Warp::squareToUniformTriangle(Point2f(s, sample.y()));
    Vector3f bary(1 - b.x() - b.y(), b.x(), b.y());

    n_UINT i0 = m_F(0, tri), i1 = m_F(1, tri), i2 = m_F(2, tri);
    Point3f p0 = m_V.col(i0), p1 = m_V.col(i1), p2 = m_V.col(i2);
    p = bary.x() * p0 + bary.y() * p1 + bary.z() * p2;

    if (m_N.size() > 0)
        n = (bary.x() * m_N.col(i0) + bary.y() * m_N.col(i1) + bary.z() * m_N.col(i2)).normalized();
    else
        n = (p1 - p0).cross(p2 - p0).normalized(); // la caja de Cornell no trae normales

    if (m_UV.size() > 0)
        uv = bary.x() * m_UV.col(i0) + bary.y() * m_UV.col(i1) + bary.z() * m_UV.col(i2);
}

float Mesh::pdf(const Point3f &p) const {
    return m_pdf.getNormalization(); // 1 / área total
}

void Mesh::addChild(NoriObject *obj, const std::string &name) {
    switch (obj->getClassType()) {
        case EBSDF:
            if (m_bsdf)
                throw NoriException("Mesh: tried to register multiple BSDF instances!");
            m_bsdf = static_cast<BSDF *>(obj);
            break;

        case EEmitter:
            if (m_emitter)
                throw NoriException("Mesh: tried to register multiple Emitter instances!");
            m_emitter = static_cast<Emitter *>(obj);
            break;

        default:
            throw NoriException("Mesh::addChild(<%s>) is not supported!",
                                classTypeName(obj->getClassType()));
    }
}

std::string Mesh::toString() const {
    return tfm::format(
        "Mesh[\n"
        "  name = \"%s\",\n"
        "  vertexCount = %i,\n"
        "  triangleCount = %i,\n"
        "  bsdf = %s,\n"
        "  emitter = %s\n"
        "]",
        m_name, m_V.cols(), m_F.cols(),
        m_bsdf ? indent(m_bsdf->toString()) : std::string("null"),
        m_emitter ? indent(m_emitter->toString()) : std::string("null"));
}

std::string Intersection::toString() const {
    if (!mesh)
        return "Intersection[invalid]";

    return tfm::format(
        "Intersection[\n"
        "  p = %s,\n"
        "  t = %f,\n"
        "  uv = %s,\n"
        "  shFrame = %s,\n"
        "  geoFrame = %s,\n"
        "  mesh = %s\n"
        "]",
        p.toString(), t, uv.toString(),
        indent(shFrame.toString()), indent(geoFrame.toString()),
        mesh ? mesh->toString() : std::string("null"));
}

NORI_NAMESPACE_END
