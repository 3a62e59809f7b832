// SPDX-License-Identifier: MIT
#include <nori/camera.h>
#include <nori/rfilter.h>

NORI_NAMESPACE_BEGIN

/// Pinhole camera that looks along its +z axis. Pixel x grows towards its -x axis, y towards -y.
class PerspectiveCamera : public Camera {
public:
    PerspectiveCamera(const PropertyList &props)
        : m_cameraToWorld(props.getTransform("toWorld", Transform())),
          m_fov(props.getFloat("fov", 30.0f)),
          m_nearClip(props.getFloat("nearClip", 1e-4f)),
          m_farClip(props.getFloat("farClip", 1e4f)) {
        m_outputSize.x() = props.getInteger("width", 1280);
        m_outputSize.y() = props.getInteger("height", 720);
        m_rfilter = nullptr;

        if (m_outputSize.x() < 1 || m_outputSize.y() < 1)
            throw NoriException("The camera has %d x %d pixels, needs at least one!",
                                m_outputSize.x(), m_outputSize.y());
        if (!(m_fov > 0.0f && m_fov < 180.0f))
            throw NoriException("Property 'fov' is %f, must be between 0 and 180 degrees!", m_fov);
        if (!(m_nearClip > 0.0f && m_nearClip < m_farClip))
            throw NoriException("Properties 'nearClip' and 'farClip' are %f and %f, must be "
                                "positive and in this order!",
                                m_nearClip, m_farClip);
        if (!m_cameraToWorld.getMatrix().allFinite() ||
            !m_cameraToWorld.getInverseMatrix().allFinite())
            throw NoriException("Property 'toWorld' of the camera is not invertible!");
    }

    ~PerspectiveCamera() override { delete m_rfilter; }

    void addChild(NoriObject *child, const std::string &) override {
        if (child->getClassType() != EReconstructionFilter)
            throw NoriException("Camera::addChild(<%s>) is not supported!",
                                classTypeName(child->getClassType()));
        if (m_rfilter != nullptr)
            throw NoriException("Camera: tried to register multiple reconstruction filters!");
        m_rfilter = static_cast<ReconstructionFilter *>(child);
    }

    void activate() override {
        const float tangent = std::tan(degToRad(0.5f * m_fov)); // fov spans the width
        m_scale = Vector2f(tangent, tangent * static_cast<float>(m_outputSize.y()) /
                                        static_cast<float>(m_outputSize.x()));
        if (m_rfilter == nullptr) {
            m_rfilter = static_cast<ReconstructionFilter *>(
                NoriObjectFactory::createInstance("gaussian", PropertyList()));
            m_rfilter->activate();
        }
    }

    Color3f sampleRay(Ray3f &ray, const Point2f &samplePosition, const Point2f &) const override {
        const float u = samplePosition.x() / static_cast<float>(m_outputSize.x());
        const float v = samplePosition.y() / static_cast<float>(m_outputSize.y());
        const Vector3f d =
            Vector3f((1.0f - 2.0f * u) * m_scale.x(), (1.0f - 2.0f * v) * m_scale.y(), 1.0f)
                .normalized();

        ray.o = m_cameraToWorld * Point3f(0.0f, 0.0f, 0.0f);
        ray.d = m_cameraToWorld * d;
        ray.mint = m_nearClip / d.z();
        ray.maxt = m_farClip / d.z();
        ray.update();
        return Color3f(1.0f);
    }

    std::string toString() const override {
        return tfm::format("PerspectiveCamera[\n"
                           "  cameraToWorld = %s,\n"
                           "  outputSize = %s,\n"
                           "  fov = %f,\n"
                           "  clip = [%f, %f],\n"
                           "  rfilter = %s\n"
                           "]",
                           indent(m_cameraToWorld.toString(), 18), m_outputSize.toString(), m_fov,
                           m_nearClip, m_farClip,
                           m_rfilter != nullptr ? indent(m_rfilter->toString()) : "null");
    }

private:
    Transform m_cameraToWorld;
    float m_fov; ///< horizontal [degrees]
    float m_nearClip, m_farClip;
    Vector2f m_scale; ///< half the size of the image plane at distance 1
};

NORI_REGISTER_CLASS(PerspectiveCamera, "perspective")

NORI_NAMESPACE_END
