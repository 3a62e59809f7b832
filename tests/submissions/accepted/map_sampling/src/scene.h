#pragma once

#include <nori/accel.h>
#include <nori/dpdf.h>
#include <nori/emitter.h>

NORI_NAMESPACE_BEGIN

/// Everything that is rendered, and with what.
class Scene : public NoriObject {
public:
    Scene(const PropertyList &);
    ~Scene() override;

    const Accel *getAccel() const { return m_accel; }

    const Integrator *getIntegrator() const { return m_integrator; }

    Integrator *getIntegrator() { return m_integrator; }

    const Camera *getCamera() const { return m_camera; }

    const Sampler *getSampler() const { return m_sampler; }

    Sampler *getSampler() { return m_sampler; }

    const std::vector<Mesh *> &getMeshes() const { return m_meshes; }

    /// All emitters: first those of the scene in document order, then those of the meshes.
    const std::vector<Emitter *> &getLights() const { return m_emitters; }

    /// Radiance that arrives along a ray which hits nothing.
    Color3f getBackground(const Ray3f &ray) const;

    /// Draws an emitter.
    ///
    /// \param rnd  uniform in [0, 1)
    /// \param pdf  receives the probability of this emitter
    const Emitter *sampleEmitter(float rnd, float &pdf) const;

    /// Probability with which sampleEmitter() draws `em`.
    float pdfEmitter(const Emitter *em) const;

    /// Null if there is none.
    const Emitter *getEnvironmentalEmitter() const { return m_enviromentalEmitter; }

    /// Nearest hit.
    bool rayIntersect(const Ray3f &ray, Intersection &its) const {
        return m_accel->rayIntersect(ray, its, false);
    }

    /// Whether the segment hits anything.
    bool rayIntersect(const Ray3f &ray) const {
        Intersection its;
        return m_accel->rayIntersect(ray, its, true);
    }

    const BoundingBox3f &getBoundingBox() const { return m_accel->getBoundingBox(); }

    /// Completes the scene: throws NoriException without integrator or camera.
    void activate() override;
    void addChild(NoriObject *obj, const std::string &name = "none") override;
    std::string toString() const override;

    EClassType getClassType() const override { return EScene; }

private:
    std::vector<Mesh *> m_meshes;             ///< owned by m_accel
    std::vector<Emitter *> m_emitters;        ///< owned here, unless by a mesh
    Emitter *m_enviromentalEmitter = nullptr; ///< also in m_emitters
    Integrator *m_integrator = nullptr;
    Sampler *m_sampler = nullptr;
    Camera *m_camera = nullptr;
    Accel *m_accel = nullptr;
    DiscretePDF emitters_pdf;
};

NORI_NAMESPACE_END
