// SPDX-License-Identifier: MIT
#pragma once

#include <nori/common.h>

NORI_NAMESPACE_BEGIN

/// Discrete distribution over the indices 0 .. size() - 1: append() weights, then normalize().
///
/// sample() draws an entry only after normalize() has returned a positive sum. What sampling does
/// with u = 0, with an entry of weight 0 and with an empty distribution is as in Nori, except that
/// nothing is read out of range.
struct DiscretePDF {
public:
    explicit DiscretePDF(size_t nEntries = 0) {
        reserve(nEntries);
        clear();
    }

    void clear() {
        m_cdf.clear();
        m_cdf.push_back(0.0f);
        m_normalized = false;
    }

    void reserve(size_t nEntries) { m_cdf.reserve(nEntries + 1); }

    /// Adds an entry of weight `pdfValue` >= 0.
    void append(float pdfValue) { m_cdf.push_back(m_cdf.back() + pdfValue); }

    size_t size() const { return m_cdf.size() - 1; }

    /// Weight of an entry; after normalize() its probability.
    float operator[](size_t entry) const { return m_cdf[entry + 1] - m_cdf[entry]; }

    bool isNormalized() const { return m_normalized; }

    /// Sum of the weights, as of the last normalize().
    float getSum() const { return m_sum; }

    /// 1 / getSum(), or 0 where that is 0.
    float getNormalization() const { return m_normalization; }

    /// Turns weights into probabilities; to be called once. \return the sum of the weights
    float normalize() {
        m_sum = m_cdf.back();
        if (m_sum > 0.0f) {
            m_normalization = 1.0f / m_sum;
            for (float &value : m_cdf)
                value *= m_normalization;
            m_cdf.back() = 1.0f;
            m_normalized = true;
        } else {
            m_normalization = 0.0f;
        }
        return m_sum;
    }

    /// Entry i with cdf[i] < u <= cdf[i + 1]; 0 for u = 0, even if its probability is 0, and for an
    /// empty distribution.
    size_t sample(float sampleValue) const {
        if (size() == 0)
            return 0;
        const auto entry = std::lower_bound(m_cdf.begin(), m_cdf.end(), sampleValue);
        const auto index = std::max<std::ptrdiff_t>(0, entry - m_cdf.begin() - 1);
        return std::min(static_cast<size_t>(index), size() - 1);
    }

    /// \param pdf  receives the probability of the entry; 0 for an empty distribution
    size_t sample(float sampleValue, float &pdf) const {
        const size_t index = sample(sampleValue);
        pdf = size() == 0 ? 0.0f : operator[](index);
        return index;
    }

    /// \param sampleValue  is replaced by its position inside the entry: again uniform in [0, 1].
    ///                     Not a number where the entry has probability 0.
    size_t sampleReuse(float &sampleValue) const {
        const size_t index = sample(sampleValue);
        if (size() != 0)
            sampleValue = (sampleValue - m_cdf[index]) / (m_cdf[index + 1] - m_cdf[index]);
        return index;
    }

    size_t sampleReuse(float &sampleValue, float &pdf) const {
        const size_t index = sample(sampleValue, pdf);
        if (size() != 0)
            sampleValue = (sampleValue - m_cdf[index]) / (m_cdf[index + 1] - m_cdf[index]);
        return index;
    }

    std::string toString() const {
        std::string result =
            tfm::format("DiscretePDF[sum=%f, normalized=%s, cdf = {", m_sum, m_normalized);
        for (size_t i = 0; i < m_cdf.size(); ++i)
            result += tfm::format(i == 0 ? "%f" : ", %f", m_cdf[i]);
        return result + "}]";
    }

private:
    std::vector<float> m_cdf; ///< shape [size() + 1], from 0
    // Nori leaves these two uninitialised; a defined 0 makes a forgotten normalize() reproducible
    float m_sum = 0.0f;
    float m_normalization = 0.0f;
    bool m_normalized = false;
};

NORI_NAMESPACE_END
