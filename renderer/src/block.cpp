// SPDX-License-Identifier: MIT
#include <nori/bitmap.h>
#include <nori/block.h>
#include <nori/rfilter.h>

#include <atomic>

NORI_NAMESPACE_BEGIN

namespace {

/// Dropped samples that are told one by one; a faulty integrator has hundreds of thousands.
constexpr int kReportedSamples = 5;

void reportInvalidSample(const Point2f &pos, const Color3f &value) {
    static std::atomic<int> reported{0};
    const int number = ++reported;
    if (number > kReportedSamples)
        return;
    // one write, so that lines of several threads do not mix
    std::string line = tfm::format("Integrator: dropped an invalid radiance value %s at pixel %s\n",
                                   value.toString(), pos.toString());
    if (number == kReportedSamples)
        line += "Integrator: further invalid values are dropped and counted only\n";
    cerr << line << std::flush;
}

} // namespace

ImageBlock::ImageBlock(const Vector2i &size, const ReconstructionFilter *filter)
    : m_offset(0, 0), m_size(size) {
    if (filter != nullptr) {
        m_filterRadius = filter->getRadius();
        m_borderSize = static_cast<int>(std::ceil(m_filterRadius - 0.5f));
        for (int i = 0; i < NORI_FILTER_RESOLUTION; ++i) {
            const float step = static_cast<float>(i) / NORI_FILTER_RESOLUTION;
            m_filter.push_back(filter->eval(m_filterRadius * step));
        }
        m_filter.push_back(0.0f);
        m_lookupFactor = NORI_FILTER_RESOLUTION / m_filterRadius;
        const auto reach = static_cast<size_t>(std::ceil(2.0f * m_filterRadius)) + 1;
        m_weightsX.resize(reach);
        m_weightsY.resize(reach);
    }
    resize(size.y() + 2 * m_borderSize, size.x() + 2 * m_borderSize);
    clear();
}

ImageBlock::~ImageBlock() = default;

void ImageBlock::clear() {
    setConstant(Color4f());
    m_invalidSampleCount = 0;
}

Bitmap *ImageBlock::toBitmap() const {
    auto result = std::make_unique<Bitmap>(m_size);
    for (int y = 0; y < m_size.y(); ++y) {
        for (int x = 0; x < m_size.x(); ++x)
            result->coeffRef(y, x) =
                coeff(y + m_borderSize, x + m_borderSize).divideByFilterWeight();
    }
    return result.release();
}

void ImageBlock::fromBitmap(const Bitmap &bitmap) {
    if (bitmap.cols() != cols() || bitmap.rows() != rows())
        throw NoriException("ImageBlock::fromBitmap(): the bitmap has %d x %d pixels, not %d x %d!",
                            bitmap.cols(), bitmap.rows(), cols(), rows());
    for (int y = 0; y < rows(); ++y) {
        for (int x = 0; x < cols(); ++x)
            coeffRef(y, x) = Color4f(bitmap.coeff(y, x));
    }
}

void ImageBlock::put(const Point2f &pos, const Color3f &value) {
    if (m_filter.empty())
        throw NoriException("ImageBlock::put(): the block has no reconstruction filter!");
    if (!value.isValid()) {
        ++m_invalidSampleCount;
        reportInvalidSample(pos, value);
        return;
    }

    // position relative to the centre of the first pixel in memory
    const float x = pos.x() - 0.5f - static_cast<float>(m_offset.x() - m_borderSize);
    const float y = pos.y() - 0.5f - static_cast<float>(m_offset.y() - m_borderSize);
    const int x0 = std::max(0, static_cast<int>(std::ceil(x - m_filterRadius)));
    const int y0 = std::max(0, static_cast<int>(std::ceil(y - m_filterRadius)));
    const int x1 =
        std::min(static_cast<int>(cols()) - 1, static_cast<int>(std::floor(x + m_filterRadius)));
    const int y1 =
        std::min(static_cast<int>(rows()) - 1, static_cast<int>(std::floor(y + m_filterRadius)));

    const auto weight = [this](int pixel, float center) {
        const float distance = std::abs(static_cast<float>(pixel) - center);
        return m_filter[std::min(static_cast<size_t>(distance * m_lookupFactor),
                                 static_cast<size_t>(NORI_FILTER_RESOLUTION))];
    };
    for (int i = x0; i <= x1; ++i)
        m_weightsX[static_cast<size_t>(i - x0)] = weight(i, x);
    for (int i = y0; i <= y1; ++i)
        m_weightsY[static_cast<size_t>(i - y0)] = weight(i, y);

    const Color4f weighted(value);
    for (int row = y0; row <= y1; ++row) {
        for (int column = x0; column <= x1; ++column)
            coeffRef(row, column) += weighted * m_weightsX[static_cast<size_t>(column - x0)] *
                                     m_weightsY[static_cast<size_t>(row - y0)];
    }
}

void ImageBlock::put(ImageBlock &b) {
    const int border = m_borderSize - b.getBorderSize();
    const int x = b.getOffset().x() - m_offset.x() + border;
    const int y = b.getOffset().y() - m_offset.y() + border;
    const int width = b.getSize().x() + 2 * b.getBorderSize();
    const int height = b.getSize().y() + 2 * b.getBorderSize();

    const std::lock_guard<std::mutex> guard(m_mutex);
    block(y, x, height, width) += b.topLeftCorner(height, width);
    m_invalidSampleCount += b.m_invalidSampleCount;
}

std::string ImageBlock::toString() const {
    return tfm::format("ImageBlock[offset=%s, size=%s]", m_offset.toString(), m_size.toString());
}

BlockGenerator::BlockGenerator(const Vector2i &size, int blockSize)
    : m_numBlocks((size.x() + blockSize - 1) / blockSize, (size.y() + blockSize - 1) / blockSize),
      m_size(size),
      m_blockSize(blockSize),
      m_blocksLeft(m_numBlocks.x() * m_numBlocks.y()) {
    m_block = Point2i(m_numBlocks.x() / 2, m_numBlocks.y() / 2);
}

bool BlockGenerator::next(ImageBlock &block) {
    const std::lock_guard<std::mutex> guard(m_mutex);
    if (m_blocksLeft <= 0)
        return false;

    const Point2i offset = m_block * m_blockSize;
    block.setOffset(offset);
    block.setSize(Point2i(std::min(m_size.x() - offset.x(), m_blockSize),
                          std::min(m_size.y() - offset.y(), m_blockSize)));
    if (--m_blocksLeft == 0)
        return true;

    // walk the spiral, over the edges of the image where need be, to the next block inside
    const Vector2i steps[] = {Vector2i(1, 0), Vector2i(0, 1), Vector2i(-1, 0), Vector2i(0, -1)};
    do {
        m_block += steps[m_direction];
        if (--m_stepsLeft == 0) {
            m_direction = (m_direction + 1) % 4;
            if (m_direction == ELeft || m_direction == ERight)
                ++m_numSteps;
            m_stepsLeft = m_numSteps;
        }
    } while ((m_block.array() < 0).any() || (m_block.array() >= m_numBlocks.array()).any());
    return true;
}

NORI_NAMESPACE_END
