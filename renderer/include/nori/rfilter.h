// SPDX-License-Identifier: MIT
#pragma once

#include <nori/object.h>

/// Steps into which ImageBlock tabulates a filter between its centre and its radius.
#define NORI_FILTER_RESOLUTION 32

NORI_NAMESPACE_BEGIN

/// Weight of a sample in the pixels around it. Two-dimensional filters are products of this one.
class ReconstructionFilter : public NoriObject {
public:
    /// Beyond it the filter is 0 [pixels].
    float getRadius() const { return m_radius; }

    /// Weight at distance `x` [pixels]; it need not integrate to 1.
    virtual float eval(float x) const = 0;

    EClassType getClassType() const override { return EReconstructionFilter; }

protected:
    float m_radius = 0.0f;
};

NORI_NAMESPACE_END
