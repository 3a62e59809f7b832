#include <nori/emitter.h>
#include <nori/warp.h>
#include <nori/mesh.h>
#include <nori/texture.h>

NORI_NAMESPACE_BEGIN

class AreaEmitter : public Emitter {
public:
    AreaEmitter(const PropertyList &props) {
        m_type = EmitterType::EMITTER_AREA;
        m_radiance = new ConstantSpectrumTexture(props.getColor("radiance", Color3f(1.f)));
        m_scale = props.getFloat("scale", 1.f);
    }

    virtual std::string toString() const {
        return tfm::format(
            "AreaLight[\n"
            "  radiance = %s,\n"
            "  scale = %f,\n"
            "]",
            m_radiance->toString(), m_scale);
    }

    // La luz sólo emite por la cara a la que apunta su normal
    virtual Color3f eval(const EmitterQueryRecord &lRec) const {
        if (!m_mesh)
            throw NoriException("There is no shape attached to this Area light!");

        float cosLuz = lRec.n.dot(-lRec.wi);
        if (cosLuz <= 0)
            return Color3f(0.f);
        return m_scale * m_radiance->eval(lRec.uv);
    }

    virtual Color3f sample(EmitterQueryRecord &lRec, const Point2f &sample, float optional_u) const {
        if (!m_mesh)
            throw NoriException("There is no shape attached to this Area light!");

        m_mesh->samplePosition(sample, lRec.p, lRec.n, lRec.uv);
        lRec.emitter = this;
        lRec.wi = lRec.p - lRec.ref;
        lRec.dist = lRec.wi.norm();
        lRec.wi /= lRec.dist;
        lRec.pdf = pdf(lRec);

        // por detrás no llega luz (y así no dividimos por cero)
        if (lRec.pdf <= 0)
            return Color3f(0.f);
        return eval(lRec) / lRec.pdf;
    }

    // pdf de área pasada a ángulo sólido: d^2 / cos
    virtual float pdf(const EmitterQueryRecord &lRec) const {
        if (!m_mesh)
            throw NoriException("There is no shape attached to this Area light!");

        float cosLuz = lRec.n.dot(-lRec.wi);
        if (cosLuz <= 0)
            return 0.f;
        return m_mesh->pdf(lRec.p) * lRec.dist * lRec.dist / cosLuz;
    }

    virtual void setParent(NoriObject *parent) {
        auto type = parent->getClassType();
        if (type == EMesh)
            setMesh(static_cast<Mesh *>(parent));
    }

    virtual void addChild(NoriObject *obj, const std::string &name = "none") {
        switch (obj->getClassType()) {
            case ETexture:
                if (name == "radiance") {
                    if (m_radiance)
                        delete m_radiance;
                    m_radiance = static_cast<Texture *>(obj);
                } else
                    throw NoriException("AreaEmitter::addChild(<%s,%s>) is not supported!",
                                        classTypeName(obj->getClassType()), name);
                break;

            default:
                throw NoriException("AreaEmitter::addChild(<%s>) is not supported!",
                                    classTypeName(obj->getClassType()));
        }
    }

protected:
    Texture *m_radiance;
    float m_scale;
};

NORI_REGISTER_CLASS(AreaEmitter, "area")
NORI_NAMESPACE_END
