// SPDX-License-Identifier: MIT
#include "figure_test.h"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace grader {

namespace {

constexpr double kTolerance = 0.01; ///< relative: other compilers, edges of shadows
constexpr double kDarkest = 0.05;   ///< what is darker than this part of the mean counts as this
constexpr double kPower = 0.999;
constexpr double kMad = 0.6745; ///< median of |x| of a standard normal x

using Colour = std::array<double, 3>;

/// An image's patches in the scale in which they are compared.
using Values = std::vector<std::vector<Colour>>;

/// \param isFile  levels of a file are whole already, but for the rounding of their decoding
Values valuesOf(const PatchImage &image, PixelScale scale, bool isFile) {
    Values values;
    values.reserve(image.size());
    for (const PatchPixels &pixels : image) {
        std::vector<Colour> patch;
        patch.reserve(pixels.size());
        for (const std::array<float, 3> &pixel : pixels) {
            Colour colour{};
            for (std::size_t c = 0; c < 3; ++c) {
                if (scale == PixelScale::Linear)
                    colour[c] = double{pixel[c]};
                else // nori cuts the fraction off
                    colour[c] =
                        isFile ? std::round(pngLevel(pixel[c])) : std::floor(pngLevel(pixel[c]));
            }
            patch.push_back(colour);
        }
        values.push_back(std::move(patch));
    }
    return values;
}

double median(std::vector<double> values) {
    if (values.empty())
        return 0;
    const auto middle = values.begin() + static_cast<long>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// P(X >= successes) for a fair coin.
double upperTail(std::size_t successes, std::size_t trials) {
    if (successes == 0 || trials == 0)
        return 1;
    const boost::math::binomial coin(static_cast<double>(trials), 0.5);
    return cdf(complement(coin, static_cast<double>(successes) - 1));
}

/// The probability of a success at which the sign test rejects with kPower; 1: at none.
double neededProbability(std::size_t trials) {
    std::size_t critical = trials + 1;
    while (critical > 0 && upperTail(critical - 1, trials) <= kFigureLevel)
        --critical;
    if (critical > trials)
        return 1;
    // P(X >= critical | p) = I_p(critical, n - critical + 1)
    return boost::math::ibeta_inv(static_cast<double>(critical),
                                  static_cast<double>(trials - critical) + 1, kPower);
}

/// Counts which of two numbers is the larger; ties at 0 say nothing.
struct SignCount {
    std::size_t larger = 0;
    std::size_t all = 0;

    void add(double a, double b) {
        if (a <= 0 && b <= 0)
            return;
        ++all;
        larger += a > b ? 1 : 0;
    }

    double pValue() const { return upperTail(larger, all); }
};

class Examination {
public:
    explicit Examination(const FigurePatches &patches)
        : m_isLinear(patches.scale == PixelScale::Linear),
          m_equalSamples(patches.equalSamples),
          m_figure(valuesOf(patches.figure, patches.scale, true)) {
        for (std::size_t i = 0; i < 3; ++i)
            m_own[i] = valuesOf(patches.own[i], patches.scale, false);
        for (const Values &own : m_own) {
            if (own.size() != m_figure.size())
                throw std::invalid_argument("examineFigure: images of different patches");
        }
        double sum = 0;
        for (std::size_t t = 0; t < m_figure.size(); ++t) {
            for (std::size_t c = 0; c < 3; ++c)
                sum += ownMean(t, c) / 3;
        }
        m_mean = m_figure.empty() ? 0 : sum / static_cast<double>(m_figure.size());
    }

    FigureFindings examine() {
        compareMeans();
        compareNoise();
        return m_found;
    }

private:
    static double meanOf(const Values &image, std::size_t patch, std::size_t channel) {
        double sum = 0;
        for (const Colour &pixel : image[patch])
            sum += pixel[channel];
        return sum / static_cast<double>(image[patch].size());
    }

    double ownMean(std::size_t patch, std::size_t channel) const {
        return (meanOf(m_own[0], patch, channel) + meanOf(m_own[1], patch, channel) +
                meanOf(m_own[2], patch, channel)) /
               3;
    }

    double tolerance(double value) const {
        return m_isLinear ? kTolerance * std::max(value, kDarkest * m_mean) : 1.0;
    }

    void compareMeans() {
        SignCount signs;
        double figureSum = 0;
        double ownSum = 0;
        std::vector<double> spreads;
        std::vector<double> x;
        std::vector<double> y;
        double variance = 0;
        double ownVariance = 0;
        for (std::size_t t = 0; t < m_figure.size(); ++t) {
            double toFigure = 0;
            double among = 0;
            double level = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double f = meanOf(m_figure, t, c);
                const double own = ownMean(t, c);
                const Colour each{meanOf(m_own[0], t, c), meanOf(m_own[1], t, c),
                                  meanOf(m_own[2], t, c)};
                toFigure += std::max(0.0, std::fabs(f - each[0]) - tolerance(own));
                among += std::fabs(each[1] - each[2]);
                variance += (f - each[0]) * (f - each[1]);
                ownVariance += (each[1] - each[2]) * (each[1] - each[2]) / 2;
                figureSum += f;
                ownSum += own;
                level += own;
                x.push_back(std::sqrt(std::max(0.0, f)));
                y.push_back(std::sqrt(std::max(0.0, own)));
            }
            signs.add(toFigure, among);
            if (level > 0)
                spreads.push_back(among / (kMad * std::sqrt(2.0) * level));
        }
        m_found.patches = signs.all;
        m_found.meanP = signs.pValue();
        m_found.meanError = ownSum > 0 ? figureSum / ownSum - 1 : 0;
        m_found.correlation = correlation(x, y);
        m_meanRatio = ownVariance > 0 ? variance / ownVariance : 1;
        const double needed = neededProbability(signs.all);
        if (needed < 1) {
            // |x + d| > |y|: with u = x - y and v = x + y, both u + d and v + d have one sign.
            const boost::math::normal normal;
            const double sigma = median(spreads);
            m_found.meanMde =
                kTolerance + 2 * sigma * quantile(normal, std::sqrt(needed)) / std::sqrt(2.0);
        }
    }

    void compareNoise() {
        SignCount more;
        SignCount less;
        std::vector<double> logs;
        std::vector<double> ratios;
        for (std::size_t t = 0; t < m_figure.size(); ++t) {
            double beyond = 0;  // squared distance to the figure, less what is tolerated
            double against = 0; // the whole of it
            double among = 0;
            double variance = 0;
            double ownVariance = 0;
            for (std::size_t i = 0; i < m_figure[t].size(); ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const double f = m_figure[t][i][c];
                    const double a = m_own[0][t][i][c];
                    const double b = m_own[1][t][i][c];
                    const double d = m_own[2][t][i][c];
                    const double left = std::max(0.0, std::fabs(f - a) - tolerance(a));
                    beyond += left * left;
                    against += (f - a) * (f - a);
                    among += (b - d) * (b - d);
                    variance += ((f - a) * (f - b) + (f - b) * (f - d) + (f - a) * (f - d)) / 3;
                    ownVariance += ((a - b) * (a - b) + (b - d) * (b - d) + (a - d) * (a - d)) / 6;
                }
            }
            more.add(beyond, among);
            less.add(among, against);
            if (ownVariance > 0)
                ratios.push_back(variance / ownVariance);
            if (among > 0 && against > 0)
                logs.push_back(std::log(against / among));
        }
        m_found.moreNoiseP = more.pValue();
        m_found.lessNoiseP = m_equalSamples ? less.pValue() : 1;
        m_found.noiseRatio = std::max(0.0, median(ratios));
        if (m_found.noiseRatio > 0)
            m_found.smoothness = std::max(0.0, m_meanRatio) / m_found.noiseRatio;
        setNoiseMde(more.all, logs);
    }

    /// From the scatter of the patches' own logarithms, taken as normal.
    void setNoiseMde(std::size_t trials, std::vector<double> logs) {
        const double needed = neededProbability(trials);
        if (needed >= 1 || logs.empty())
            return;
        const double centre = median(logs);
        for (double &value : logs)
            value = std::fabs(value - centre);
        const boost::math::normal normal;
        const double factor = std::exp(median(logs) / kMad * quantile(normal, needed));
        m_found.moreNoiseMde = 2 * factor - 1;
        if (m_equalSamples)
            m_found.lessNoiseMde = std::max(0.0, 2 / factor - 1);
    }

    static double correlation(const std::vector<double> &x, const std::vector<double> &y) {
        const auto n = static_cast<double>(x.size());
        const double meanX = std::accumulate(x.begin(), x.end(), 0.0) / n;
        const double meanY = std::accumulate(y.begin(), y.end(), 0.0) / n;
        double xx = 0;
        double yy = 0;
        double xy = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            xx += (x[i] - meanX) * (x[i] - meanX);
            yy += (y[i] - meanY) * (y[i] - meanY);
            xy += (x[i] - meanX) * (y[i] - meanY);
        }
        return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : 0;
    }

    bool m_isLinear;
    bool m_equalSamples;
    Values m_figure;
    std::array<Values, 3> m_own;
    double m_mean = 0;      ///< of the own images
    double m_meanRatio = 1; ///< variance of the figure's patch means over the own ones'
    FigureFindings m_found;
};

} // namespace

FigureFindings examineFigure(const FigurePatches &patches) {
    return Examination(patches).examine();
}

} // namespace grader
