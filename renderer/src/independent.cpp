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
        m_random.seed(static_cast<uint64_t>(offset.x()) + mix(static_cast<uint64_t>(m_seed)),
                      static_cast<uint64_t>(offset.y()) + mix(~static_cast<uint64_t>(m_seed)));
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
    /// Nori adds the seed to the block's position: seeds that differ by the size of a block then
    /// give the same noise, shifted by a block. Seed 0 keeps Nori's numbers.
    uint64_t mix(uint64_t z) const {
        if (m_seed == 0)
            return 0;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull; // SplitMix64
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }

    int m_seed;
    pcg32 m_random;
};

NORI_REGISTER_CLASS(Independent, "independent")

NORI_NAMESPACE_END
