#include <nori/emitter.h>
#include <nori/bitmap.h>
#include <nori/dpdf.h>
#include <nori/warp.h>
#include <filesystem/resolver.h>

NORI_NAMESPACE_BEGIN

class EnvironmentEmitter : public Emitter {
public:
    EnvironmentEmitter(const PropertyList &props) {
        m_type = EmitterType::EMITTER_ENVIRONMENT;
        m_radiance = props.getColor("radiance", Color3f(1.f));
        std::string nombre = props.getString("filename", "null");
        m_environment = nullptr;
        m_environment_name = nombre;
        if (nombre != "null") {
            filesystem::path ruta = getFileResolver()->resolve(nombre);
            m_environment = new Bitmap(ruta.str());
            construirTablas();
        }
    }

    virtual ~EnvironmentEmitter() {
        delete m_environment;
    }

    virtual std::string toString() const {
        return tfm::format("EnvironmentEmitter[\n  radiance = %s,\n  environment = %s\n]",
                           m_radiance.toString(), m_environment_name);
    }

    virtual Color3f eval(const EmitterQueryRecord &lRec) const {
        if (!m_environment)
            return m_radiance;
        return m_environment->eval(aUV(lRec.wi)) * m_radiance;
    }

    virtual Color3f sample(EmitterQueryRecord &lRec, const Point2f &sample, float optional_u) const {
        if (m_environment) {
            // fila con sample.y, columna dentro de la fila con sample.x
            Point2f s = sample;
            size_t i = m_filas.sampleReuse(s.y());
            size_t j = m_columnas[i].sampleReuse(s.x());
            lRec.wi = deUV(Point2f((j + s.x()) / ANCHO, (i + s.y()) / ALTO));
        } else {
            lRec.wi = Warp::squareToUniformSphere(sample);
        }
        lRec.emitter = this;
        lRec.dist = 1e8f;
        lRec.p = lRec.ref + lRec.dist * lRec.wi;
        lRec.n = -lRec.wi;
        lRec.pdf = pdf(lRec);
        if (lRec.pdf <= 0.f)
            return Color3f(0.f);
        return eval(lRec) / lRec.pdf;
    }

    virtual float pdf(const EmitterQueryRecord &lRec) const {
        if (!m_environment)
            return Warp::squareToUniformSpherePdf(lRec.wi);

        Point2f uv = aUV(lRec.wi);
        int i = std::min(int(uv.y() * ALTO), ALTO - 1);
        int j = std::min(int(uv.x() * ANCHO), ANCHO - 1);
        // seno con x,z: con 1 - y*y se pierde todo cerca de los polos
        float seno = std::sqrt(lRec.wi.x() * lRec.wi.x() + lRec.wi.z() * lRec.wi.z());
        if (seno == 0.f)
            return 0.f;
        // densidad en (u,v), y de ahí a ángulo sólido: dw = 2 pi^2 sen(theta) du dv
        float puv = m_filas[i] * ALTO * m_columnas[i][j] * ANCHO;
        return puv / (2.f * M_PI * M_PI * seno);
    }

    virtual Color3f power() const {
        return M_PI * m_radiance;
    }

private:
    // (u,v) del mapa con el mismo convenio que eval
    static Point2f aUV(const Vector3f &w) {
        float u = std::atan2(w.z(), w.x()) * INV_TWOPI;
        if (u < 0.f)
            u += 1.f;
        return Point2f(u, std::acos(clamp(w.y(), -1.f, 1.f)) * INV_PI);
    }

    static Vector3f deUV(const Point2f &uv) {
        float phi = 2.f * M_PI * uv.x(), theta = M_PI * uv.y();
        return Vector3f(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    }

    void construirTablas() {
        // media de luminancia de cada celda, en 4x4 puntos
        std::vector<float> lum(ALTO * ANCHO);
        float total = 0.f;
        for (int i = 0; i < ALTO; i++)
            for (int j = 0; j < ANCHO; j++) {
                float suma = 0.f;
                for (int k = 0; k < 16; k++) {
                    Point2f uv((j + (k % 4 + 0.5f) / 4) / ANCHO, (i + (k / 4 + 0.5f) / 4) / ALTO);
                    suma += m_environment->eval(uv).getLuminance();
                }
                lum[i * ANCHO + j] = suma / 16;
                total += suma / 16;
            }
        // un mínimo en todas, para no dejar a cero ninguna celda con algo de luz
        float minimo = 0.05f * total / (ALTO * ANCHO) + 1e-12f;

        for (int i = 0; i < ALTO; i++) {
            DiscretePDF fila(ANCHO);
            for (int j = 0; j < ANCHO; j++)
                fila.append(lum[i * ANCHO + j] + minimo);
            float s = fila.normalize();
            m_columnas.push_back(fila);
            m_filas.append(s * std::sin(M_PI * (i + 0.5f) / ALTO));
        }
        m_filas.normalize();
    }

    static const int ANCHO = 64;
    static const int ALTO = 32;

    Color3f m_radiance;
    Bitmap *m_environment;
    std::string m_environment_name;
    DiscretePDF m_filas;
    std::vector<DiscretePDF> m_columnas;
};

NORI_REGISTER_CLASS(EnvironmentEmitter, "environment")
NORI_NAMESPACE_END
