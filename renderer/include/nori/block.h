// SPDX-License-Identifier: MIT
#pragma once

#include <nori/bbox.h>
#include <nori/color.h>

#include <tbb/mutex.h> // for submissions, which get it from here in Nori

#include <memory>
#include <mutex>

/// Side of the squares that are rendered as one task [pixels].
#define NORI_BLOCK_SIZE 32

NORI_NAMESPACE_BEGIN

/// Part of an image under construction: weighted sums per pixel, with a border that takes what the
/// filter spreads beyond the block's own pixels.
class ImageBlock : public Eigen::Array<Color4f, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> {
public:
    typedef Eigen::Array<Color4f, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Base;

    /// \param size    (columns, rows) without the border
    /// \param filter  tabulated here and not kept; null: no border, put(Point2f) not allowed
    ImageBlock(const Vector2i &size, const ReconstructionFilter *filter);
    ~ImageBlock();

    /// Position of the block's upper left pixel in the image.
    void setOffset(const Point2i &offset) { m_offset = offset; }

    const Point2i &getOffset() const { return m_offset; }

    /// Size of the part in use, without the border; it may not grow beyond what was allocated.
    void setSize(const Point2i &size) { m_size = size; }

    const Vector2i &getSize() const { return m_size; }

    /// Width of the border on each side [pixels].
    int getBorderSize() const { return m_borderSize; }

    /// Divides by the weights and drops the border. The caller owns the result.
    Bitmap *toBitmap() const;

    /// Takes the pixels of an image of the same size, each with weight 1.
    void fromBitmap(const Bitmap &bitmap);

    /// All sums and counts become 0.
    void clear();

    /// Adds a sample at `pos` [pixels of the whole image]. A value that is negative or not finite
    /// is dropped, weight and all, as in Nori; the first few are reported on stderr.
    void put(const Point2f &pos, const Color3f &value);

    /// Adds another block, with its border, at its place. Locks this one.
    void put(ImageBlock &b);

    /// Samples dropped so far, in this block and in those that were added to it.
    size_t getInvalidSampleCount() const { return m_invalidSampleCount; }

    void lock() const { m_mutex.lock(); }

    void unlock() const { m_mutex.unlock(); }

    std::string toString() const;

private:
    Point2i m_offset;
    Vector2i m_size;
    int m_borderSize = 0;
    float m_filterRadius = 0.0f;
    float m_lookupFactor = 0.0f;   ///< from a distance [pixels] to an index of m_filter
    std::vector<float> m_filter;   ///< weights at NORI_FILTER_RESOLUTION steps, then a 0
    std::vector<float> m_weightsX; ///< weights of the columns that the current sample reaches
    std::vector<float> m_weightsY;
    size_t m_invalidSampleCount = 0;
    mutable std::mutex m_mutex;
};

/// Hands out the blocks of an image in a spiral from its centre. Safe to call from several threads.
class BlockGenerator {
public:
    /// \param size       size of the image [pixels]
    /// \param blockSize  side of a block [pixels]
    BlockGenerator(const Vector2i &size, int blockSize);

    /// Sets offset and size of `block` to the next one; false when there are none left.
    bool next(ImageBlock &block);

    /// Blocks in total.
    int getBlockCount() const { return m_numBlocks.x() * m_numBlocks.y(); }

private:
    enum EDirection { ERight = 0, EDown, ELeft, EUp };

    Point2i m_block;
    Vector2i m_numBlocks;
    Vector2i m_size;
    int m_blockSize;
    int m_numSteps = 1;
    int m_blocksLeft;
    int m_stepsLeft = 1;
    int m_direction = ERight;
    std::mutex m_mutex;
};

NORI_NAMESPACE_END
