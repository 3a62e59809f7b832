// SPDX-License-Identifier: MIT
#pragma once

#include <nori/object.h>

NORI_NAMESPACE_BEGIN

/// Makes the rays of an image.
class Camera : public NoriObject {
public:
    /// \param ray             receives the ray in world space
    /// \param samplePosition  position on the film [pixels, fractional]
    /// \param apertureSample  uniform in [0, 1)^2
    /// \return                weight of the ray's radiance
    virtual Color3f sampleRay(Ray3f &ray, const Point2f &samplePosition,
                              const Point2f &apertureSample) const = 0;

    /// Width and height [pixels].
    const Vector2i &getOutputSize() const { return m_outputSize; }

    const ReconstructionFilter *getReconstructionFilter() const { return m_rfilter; }

    EClassType getClassType() const override { return ECamera; }

protected:
    Vector2i m_outputSize;
    ReconstructionFilter *m_rfilter = nullptr; ///< owned
};

NORI_NAMESPACE_END
