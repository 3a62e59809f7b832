#include <nori/emitter.h>
#include <nori/bitmap.h>
#include <nori/warp.h>
#include <filesystem/resolver.h>

NORI_NAMESPACE_BEGIN

class EnvironmentEmitter : public Emitter {
public:
    EnvironmentEmitter(const PropertyList &props) {
        m_type = EmitterType::EMITTER_ENVIRONMENT;
        m_radiance = props.getColor("radiance", Color3f(1.f));
        m_environment_name = props.getString("filename", "null");
        m_environment = 0;
        if (m_environment_name != "null") {
            filesystem::path filename = getFileResolver()->resolve(m_environment_name);
            m_environment = new Bitmap(filename.str());
        }
    }

    ~EnvironmentEmitter() {
        delete m_environment;
    }

    virtual std::string toString() const {
        return tfm::format(
            "EnvironmentEmitter[\n"
            "  radiance = %s,\n"
            "  environment = %s,\n"
            "]",
            m_radiance.toString(), m_environment_name);
    }

    virtual Color3f eval(const EmitterQueryRecord &lRec) const {
        if (!m_environment)
            return m_radiance;

        float phi = atan2(lRec.wi[2], lRec.wi[0]);
        if (phi < 0)
            phi += 2 * M_PI;
        float x = phi / (2 * M_PI);
        float y = acos(clamp(lRec.wi[1], -1.f, 1.f)) / M_PI;
        return m_environment->eval(Point2f(x, y)) * m_radiance;
    }

    // Dirección uniforme en toda la esfera
    virtual Color3f sample(EmitterQueryRecord &lRec, const Point2f &sample, float optional_u) const {
        lRec.emitter = this;
        lRec.wi = Warp::squareToUniformSphere(sample);
        lRec.dist = 1e7f; // "infinito", pero que se pueda multiplicar
        lRec.p = lRec.ref + lRec.dist * lRec.wi;
        lRec.n = -lRec.wi;
        lRec.uv = Point2f(0.f);
        lRec.pdf = pdf(lRec);
        return eval(lRec) / lRec.pdf;
    }

    virtual float pdf(const EmitterQueryRecord &lRec) const {
        return Warp::squareToUniformSpherePdf(lRec.wi);
    }

protected:
    Color3f m_radiance;
    Bitmap *m_environment;
    std::string m_environment_name;
};

NORI_REGISTER_CLASS(EnvironmentEmitter, "environment")
NORI_NAMESPACE_END
