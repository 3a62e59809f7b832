#pragma once

#include <nori/mesh.h>
#include <nori/object.h>

NORI_NAMESPACE_BEGIN

enum class EmitterType {
    EMITTER_POINT,
    EMITTER_DISTANT_DISK,
    EMITTER_AREA,
    EMITTER_ENVIRONMENT,
    EMITTER_UNKNOWN
};

/// Question to an emitter: which light does `ref` get from `p`? What Nori leaves uninitialised is
/// null or 0 here, so that forgetting it is reproducible.
struct EmitterQueryRecord {
    const Emitter *emitter = nullptr; ///< the light
    Point3f ref;                      ///< the point that is lit; set by the caller
    Point3f p;                        ///< the point on the light
    Normal3f n;                       ///< its normal
    Point2f uv;                       ///< its texture coordinates
    float pdf = 0.0f;                 ///< density of wi as seen from ref [1/sr]; 1 for point lights
    Vector3f wi;                      ///< unit vector from ref to p
    float dist = 0.0f;                ///< distance from ref to p

    EmitterQueryRecord() = default;

    /// For Emitter::sample(), which fills in the rest.
    EmitterQueryRecord(const Point3f &ref_) : ref(ref_) {}

    /// For Emitter::eval() and Emitter::pdf().
    EmitterQueryRecord(const Emitter *emitter_, const Point3f &ref_, const Point3f &p_,
                       const Normal3f &n_, const Point2f &uv_)
        : emitter(emitter_), ref(ref_), p(p_), n(n_), uv(uv_) {
        wi = p - ref;
        dist = wi.norm();
        wi /= dist;
    }

    std::string toString() const {
        return tfm::format("EmitterQueryRecord[\n"
                           "  ref = %s,\n"
                           "  p = %s,\n"
                           "  n = %s,\n"
                           "  uv = %s,\n"
                           "  wi = %s,\n"
                           "  dist = %f,\n"
                           "  pdf = %f\n"
                           "]",
                           ref.toString(), p.toString(), n.toString(), uv.toString(), wi.toString(),
                           dist, pdf);
    }
};

/// A light.
class Emitter : public NoriObject {
public:
    /// Draws a direction towards the light.
    ///
    /// \param lRec        lRec.ref is the point that is lit; receives all other fields
    /// \param sample      uniform in [0, 1)^2
    /// \param optional_u  one more uniform number, for lights that need it
    /// \return            incident radiance over its density; black where no light comes from
    virtual Color3f sample(EmitterQueryRecord &lRec, const Point2f &sample,
                           float optional_u) const = 0;

    /// Density with which sample() draws lRec.wi [1/sr]. Choosing this light among others is apart.
    virtual float pdf(const EmitterQueryRecord &lRec) const = 0;

    /// Radiance that leaves lRec.p towards lRec.ref, that is along -lRec.wi.
    virtual Color3f eval(const EmitterQueryRecord &lRec) const = 0;


    virtual Color3f power() const = 0;

    /// The mesh whose surface emits; not owned.
    void setMesh(Mesh *mesh) { m_mesh = mesh; }

    EClassType getClassType() const override { return EEmitter; }

    EmitterType getEmitterType() const { return m_type; }

    /// Whether the light has no extent, so that no ray can hit it.
    bool isDelta() const { return m_type == EmitterType::EMITTER_POINT; }

protected:
    Mesh *m_mesh = nullptr;
    EmitterType m_type = EmitterType::EMITTER_UNKNOWN;
};

NORI_NAMESPACE_END
