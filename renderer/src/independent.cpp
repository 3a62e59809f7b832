// SPDX-License-Identifier: MIT
#include <nori/block.h>
#include <nori/sampler.h>

#include <pcg32.h>

NORI_NAMESPACE_BEGIN

/// Independent pseudo-random numbers, the same for a block whatever thread renders it.
class Independent : public Sampler {
public:
    Independent(const PropertyList &props) : m_seed(props.getInteger("seed", 0)) {
        const int sampleCount = props.getInteger("sampleCount", 1);
        if (sampleCount < 1)
            throw NoriException("Property 'sampleCount' is %d, must be at least 1!", sampleCount);
        m_sampleCount = static_cast<size_t>(sampleCount);
    }

    std::unique_ptr<Sampler> clone() const override { return std::make_unique<Independent>(*this); }

    void prepare(const ImageBlock &block) override {
        const Point2i &offset = block.getOffset();
        m_random.seed(static_cast<uint64_t>(int64_t{offset.x()} + m_seed),
                      static_cast<uint64_t>(int64_t{offset.y()} + m_seed));
    }

    void generate() override {}

    void advance() override {}

    float next1D() override { return m_random.nextFloat(); }

    Point2f next2D() override {
        // y first: the order in which g++ evaluates the arguments in Nori's own code
        const float y = m_random.nextFloat();
        const float x = m_random.nextFloat();
        return {x, y};
    }

    std::string toString() const override {
        return tfm::format("Independent[sampleCount=%d, seed=%d]", m_sampleCount, m_seed);
    }

private:
    int m_seed;
    pcg32 m_random;
};

NORI_REGISTER_CLASS(Independent, "independent")

NORI_NAMESPACE_END
