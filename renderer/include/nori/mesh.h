// SPDX-License-Identifier: MIT
#pragma once

#include <nori/bbox.h>
#include <nori/dpdf.h>
#include <nori/frame.h>
#include <nori/object.h>

#ifndef n_UINT
#define n_UINT uint32_t
#endif

NORI_NAMESPACE_BEGIN

/// What a ray has hit.
struct Intersection {
    Point3f p;                  ///< position
    float t = 0.0f;             ///< distance along the ray in units of its direction
    Point2f uv;                 ///< texture coordinates, or barycentric ones if the mesh has none
    Frame shFrame;              ///< from interpolated vertex normals, if there are any
    Frame geoFrame;             ///< from the face's winding
    const Mesh *mesh = nullptr; ///< null: nothing was hit

    /// World to shading coordinates.
    Vector3f toLocal(const Vector3f &d) const { return shFrame.toLocal(d); }

    /// Shading to world coordinates.
    Vector3f toWorld(const Vector3f &d) const { return shFrame.toWorld(d); }

    std::string toString() const;
};

/// Triangle mesh with one BSDF and at most one emitter.
class Mesh : public NoriObject {
public:
    ~Mesh() override;

    /// Gives a mesh without BSDF a diffuse one, and prepares samplePosition().
    void activate() override;

    n_UINT getTriangleCount() const { return static_cast<n_UINT>(m_F.cols()); }

    n_UINT getVertexCount() const { return static_cast<n_UINT>(m_V.cols()); }

    /// Uniform point on the surface.
    ///
    /// \param sample  uniform in [0, 1)^2
    /// \param p       receives the position
    /// \param n       receives the unit normal: interpolated, or of the face without normals
    /// \param uv      receives interpolated texture coordinates; unchanged if there are none
    void samplePosition(const Point2f &sample, Point3f &p, Normal3f &n, Point2f &uv) const;

    /// Density of samplePosition() over the surface [1/area]; the same for every `p`.
    float pdf(const Point3f &p) const;

    /// Area of one triangle.
    float surfaceArea(n_UINT index) const;

    const BoundingBox3f &getBoundingBox() const { return m_bbox; }

    BoundingBox3f getBoundingBox(n_UINT index) const;
    Point3f getCentroid(n_UINT index) const;

    /// Two-sided intersection with one triangle (Moeller and Trumbore 1997).
    ///
    /// \param u,v  receive the barycentric weights of the face's second and third vertex
    /// \param t    receives the distance in units of ray.d
    bool rayIntersect(n_UINT index, const Ray3f &ray, float &u, float &v, float &t) const;

    /// Shape [3, vertices].
    const MatrixXf &getVertexPositions() const { return m_V; }

    /// Shape [3, vertices], or empty.
    const MatrixXf &getVertexNormals() const { return m_N; }

    /// Shape [2, vertices], or empty.
    const MatrixXf &getVertexTexCoords() const { return m_UV; }

    /// Shape [3, triangles].
    const MatrixXu &getIndices() const { return m_F; }

    bool isEmitter() const { return m_emitter != nullptr; }

    Emitter *getEmitter() { return m_emitter; }

    const Emitter *getEmitter() const { return m_emitter; }

    const BSDF *getBSDF() const { return m_bsdf; }

    /// A BSDF or an emitter, one of each.
    void addChild(NoriObject *child, const std::string &name = "none") override;

    const std::string &getName() const { return m_name; }

    std::string toString() const override;

    EClassType getClassType() const override { return EMesh; }

protected:
    Mesh();

    std::string m_name;           ///< for people
    MatrixXf m_V;                 ///< positions
    MatrixXf m_N;                 ///< normals
    MatrixXf m_UV;                ///< texture coordinates
    MatrixXu m_F;                 ///< faces
    BSDF *m_bsdf = nullptr;       ///< owned
    Emitter *m_emitter = nullptr; ///< owned
    BoundingBox3f m_bbox;
    DiscretePDF m_pdf; ///< over the triangles, by area
};

NORI_NAMESPACE_END
