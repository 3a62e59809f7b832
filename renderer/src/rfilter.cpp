// SPDX-License-Identifier: MIT
#include <nori/rfilter.h>

NORI_NAMESPACE_BEGIN

namespace {

float positiveProperty(const PropertyList &props, const std::string &name, float defaultValue) {
    const float value = props.getFloat(name, defaultValue);
    if (!(value > 0.0f && value < 100.0f))
        throw NoriException("Property '%s' of a filter is %f, must be above 0 and below 100!", name,
                            value);
    return value;
}

} // namespace

/// Gaussian, shifted so that it reaches 0 at its radius; negligible ringing, little blur.
class GaussianFilter : public ReconstructionFilter {
public:
    GaussianFilter(const PropertyList &props) : m_stddev(positiveProperty(props, "stddev", 0.5f)) {
        m_radius = positiveProperty(props, "radius", 2.0f);
    }

    float eval(float x) const override {
        const float alpha = -1.0f / (2.0f * m_stddev * m_stddev);
        return std::max(0.0f, std::exp(alpha * x * x) - std::exp(alpha * m_radius * m_radius));
    }

    std::string toString() const override {
        return tfm::format("GaussianFilter[radius=%f, stddev=%f]", m_radius, m_stddev);
    }

private:
    float m_stddev; ///< standard deviation [pixels]
};

/// Cubic of Mitchell and Netravali (1988), stretched to its radius. Sharper; has negative lobes.
class MitchellNetravaliFilter : public ReconstructionFilter {
public:
    MitchellNetravaliFilter(const PropertyList &props)
        : m_B(props.getFloat("B", 1.0f / 3.0f)), m_C(props.getFloat("C", 1.0f / 3.0f)) {
        m_radius = positiveProperty(props, "radius", 2.0f);
    }

    float eval(float x) const override {
        const float t = std::abs(2.0f * x / m_radius);
        const float t2 = t * t;
        const float t3 = t2 * t;
        if (t < 1.0f)
            return ((12.0f - 9.0f * m_B - 6.0f * m_C) * t3 +
                    (-18.0f + 12.0f * m_B + 6.0f * m_C) * t2 + (6.0f - 2.0f * m_B)) /
                   6.0f;
        if (t < 2.0f)
            return ((-m_B - 6.0f * m_C) * t3 + (6.0f * m_B + 30.0f * m_C) * t2 +
                    (-12.0f * m_B - 48.0f * m_C) * t + (8.0f * m_B + 24.0f * m_C)) /
                   6.0f;
        return 0.0f;
    }

    std::string toString() const override {
        return tfm::format("MitchellNetravaliFilter[radius=%f, B=%f, C=%f]", m_radius, m_B, m_C);
    }

private:
    float m_B, m_C;
};

/// Linear from 1 to 0 over one pixel.
class TentFilter : public ReconstructionFilter {
public:
    TentFilter(const PropertyList &) { m_radius = 1.0f; }

    float eval(float x) const override { return std::max(0.0f, 1.0f - std::abs(x)); }

    std::string toString() const override { return "TentFilter[]"; }
};

/// Every sample counts for its own pixel alone, so that pixels are independent.
class BoxFilter : public ReconstructionFilter {
public:
    BoxFilter(const PropertyList &) { m_radius = 0.5f; }

    float eval(float) const override { return 1.0f; }

    std::string toString() const override { return "BoxFilter[]"; }
};

NORI_REGISTER_CLASS(GaussianFilter, "gaussian")
NORI_REGISTER_CLASS(MitchellNetravaliFilter, "mitchell")
NORI_REGISTER_CLASS(TentFilter, "tent")
NORI_REGISTER_CLASS(BoxFilter, "box")

NORI_NAMESPACE_END
