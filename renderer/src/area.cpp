// SPDX-License-Identifier: MIT
#include <nori/emitter.h>
#include <nori/texture.h>
#include <nori/warp.h>

#include <memory>

NORI_NAMESPACE_BEGIN

/// Makes the surface of a mesh emit, on the side of its normals only.
class AreaEmitter : public Emitter {
public:
    AreaEmitter(const PropertyList &props)
        : m_radiance(new ConstantSpectrumTexture(props.getColor("radiance", Color3f(1.0f)))),
          m_scale(props.getFloat("scale", 1.0f)) {
        m_type = EmitterType::EMITTER_AREA;
    }

    Color3f eval(const EmitterQueryRecord &lRec) const override {
        if (m_mesh == nullptr)
            throw NoriException("There is no shape attached to this Area light!");
        // graded: begin AreaEmitter::eval() is not yet implemented!
        if (lRec.n.dot(lRec.wi) >= 0.0f) // wi points to the light, so this is its back
            return Color3f(0.0f);
        return m_scale * m_radiance->eval(lRec.uv);
        // graded: end
    }

    Color3f sample(EmitterQueryRecord &lRec, const Point2f &sample, float) const override {
        if (m_mesh == nullptr)
            throw NoriException("There is no shape attached to this Area light!");
        // graded: begin AreaEmitter::sample() is not yet implemented!
        lRec.emitter = this;
        m_mesh->samplePosition(sample, lRec.p, lRec.n, lRec.uv);
        lRec.wi = lRec.p - lRec.ref;
        lRec.dist = lRec.wi.norm();
        if (lRec.dist > 0.0f)
            lRec.wi /= lRec.dist;
        lRec.pdf = pdf(lRec);
        if (lRec.pdf == 0.0f)
            return Color3f(0.0f);
#ifdef NORI_SAMPLE_RETURNS_VALUE
        return eval(lRec);
#else
        return eval(lRec) / lRec.pdf;
#endif
        // graded: end
    }

    float pdf(const EmitterQueryRecord &lRec) const override {
        if (m_mesh == nullptr)
            throw NoriException("There is no shape attached to this Area light!");
        // graded: begin AreaEmitter::pdf() is not yet implemented!
        // the back counts as well: sample() draws its points too
        const float cosTheta = std::abs(lRec.n.dot(lRec.wi));
        if (cosTheta == 0.0f) // edge-on: the surface fills no solid angle
            return 0.0f;
        return m_mesh->pdf(lRec.p) * lRec.dist * lRec.dist / cosTheta;
        // graded: end
    }

    // graded: begin

    // These three are no overrides: submissions add pure virtual functions of these names.

    /// Mean over the surface, by quadrature.
    Color3f radiance() const {
        constexpr int kCells = 32;
        Color3f sum(0.0f);
        for (int i = 0; i < kCells * kCells; ++i) {
            const int row = i / kCells;
            const Point2f center((static_cast<float>(i % kCells) + 0.5f) / kCells,
                                 (static_cast<float>(row) + 0.5f) / kCells);
            Point3f p;
            Normal3f n;
            Point2f uv;
            m_mesh->samplePosition(center, p, n, uv);
            sum += m_radiance->eval(uv);
        }
        return m_scale * sum / static_cast<float>(kCells * kCells);
    }

    // NOLINTNEXTLINE(modernize-use-override): see above
    Color3f power() const {
        return M_PI / m_mesh->pdf(Point3f()) * radiance();
    }

    float getLuminance() const {
        return radiance().getLuminance();
    }

    // graded: else
    //# // For headers of yours that ask every emitter for one of these.
    //# Color3f radiance() const { return m_scale * m_radiance->eval(Point2f(0.5f)); }
    //# Color3f power() const { return radiance(); }
    //# float getLuminance() const { return radiance().getLuminance(); }
    // graded: end

    void setParent(NoriObject *parent) override {
        if (parent->getClassType() == EMesh)
            setMesh(static_cast<Mesh *>(parent));
        else
            throw NoriException(
                "An area light stands in the <mesh> that it makes emit, not in a <%s>!",
                classTypeName(parent->getClassType()));
    }

    void addChild(NoriObject *child, const std::string &name) override {
        if (child->getClassType() != ETexture || name != "radiance")
            throw NoriException("AreaEmitter::addChild(<%s name=\"%s\">) is not supported; only a "
                                "texture called \"radiance\"!",
                                classTypeName(child->getClassType()), name);
        m_radiance.reset(static_cast<Texture *>(child));
    }

    std::string toString() const override {
        return tfm::format("AreaEmitter[\n"
                           "  radiance = %s,\n"
                           "  scale = %f\n"
                           "]",
                           indent(m_radiance->toString()), m_scale);
    }

protected:
    std::unique_ptr<Texture> m_radiance;
    float m_scale;
};

NORI_REGISTER_CLASS(AreaEmitter, "area")

NORI_NAMESPACE_END
