// SPDX-License-Identifier: MIT
#pragma once

#include <nori/object.h>

#include <memory>

NORI_NAMESPACE_BEGIN

/// Source of random numbers in [0, 1), one per thread.
class Sampler : public NoriObject {
public:
    /// A sampler of the same kind and settings, for another thread.
    virtual std::unique_ptr<Sampler> clone() const = 0;

    /// Called before an image block is rendered; makes its numbers depend on the block alone.
    virtual void prepare(const ImageBlock &block) = 0;

    /// Starts a pixel. The render loop does not call it.
    virtual void generate() = 0;

    /// Goes on to the next sample of the pixel. The render loop does not call it.
    virtual void advance() = 0;

    virtual float next1D() = 0;
    virtual Point2f next2D() = 0;

    /// Samples per pixel.
    virtual size_t getSampleCount() const { return m_sampleCount; }

    EClassType getClassType() const override { return ESampler; }

protected:
    size_t m_sampleCount = 0;
};

NORI_NAMESPACE_END
