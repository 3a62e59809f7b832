// SPDX-License-Identifier: MIT
#pragma once

#include <nori/mesh.h>

#include <memory>

NORI_NAMESPACE_BEGIN

/// Finds what rays hit.
class Accel {
public:
    Accel();
    ~Accel();
    Accel(const Accel &) = delete;
    Accel &operator=(const Accel &) = delete;

    /// Takes ownership. Only before build().
    void addMesh(Mesh *mesh);

    /// To be called once, after the last addMesh().
    void build();

    const BoundingBox3f &getBoundingBox() const { return m_bbox; }

    n_UINT getMeshCount() const { return static_cast<n_UINT>(m_meshes.size()); }

    n_UINT getTriangleCount() const;

    Mesh *getMesh(n_UINT index) { return m_meshes[index]; }

    const Mesh *getMesh(n_UINT index) const { return m_meshes[index]; }

    /// Nearest hit of the ray's segment.
    ///
    /// \param ray        a mint of exactly Epsilon grows with the coordinates of ray.o
    /// \param its        its.t becomes infinite on a miss, all else stays
    /// \param shadowRay  whether anything is hit is all that is asked: its is not filled
    bool rayIntersect(const Ray3f &ray, Intersection &its, bool shadowRay = false) const;

private:
    struct Backend; ///< the ray tracing library's objects

    std::vector<Mesh *> m_meshes; ///< owned
    BoundingBox3f m_bbox;
    std::unique_ptr<Backend> m_backend;
};

NORI_NAMESPACE_END
