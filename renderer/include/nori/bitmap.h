// SPDX-License-Identifier: MIT
#pragma once

#include <nori/color.h>
#include <nori/vector.h>

NORI_NAMESPACE_BEGIN

/// Pixel of an 8-bit image.
typedef Eigen::Array<uint8_t, 3, 1> Color3b;

/// Linear RGB image in floats; shape [rows, columns], row 0 on top.
class Bitmap : public Eigen::Array<Color3f, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> {
public:
    typedef Eigen::Array<Color3f, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Base;

    /// \param size  (columns, rows); the pixels are black
    Bitmap(const Vector2i &size = Vector2i(0, 0)) : Base(size.y(), size.x()) {}

    /// Reads an OpenEXR file with channels R, G, B (also red, green, blue, also of a layer).
    /// \throws NoriException  if it cannot be read or lacks one of them
    Bitmap(const std::string &filename);

    /// Writes `filename`.exr in 32-bit floats. Throws NoriException, and leaves no half a file.
    void saveEXR(const std::string &filename) const;

    /// Writes `filename`.png with the sRGB curve. Throws NoriException, and leaves no half a file.
    void savePNG(const std::string &filename) const;

    /// Bilinear lookup at column (1 - u) width and row (1 - v) height, wrapping around.
    /// \return a 255th of the stored value, although it is not an 8-bit one: as in Nori 2, whose
    ///         scenes are made for it
    Color3f eval(const Point2f &uv) const;
};

/// Image of 8 bits per channel, as stored: no colour curve is undone.
class LDRBitmap : public Eigen::Array<Color3b, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> {
public:
    typedef Eigen::Array<Color3b, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Base;

    /// \param size  (columns, rows)
    LDRBitmap(const Vector2i &size = Vector2i(0, 0)) : Base(size.y(), size.x()) {}

    /// Reads a PNG or JPEG file, told apart by content. Throws NoriException.
    LDRBitmap(const std::string &filename);

    /// As Bitmap::eval(): white is 1.
    Color3f eval(const Point2f &uv) const;
};

NORI_NAMESPACE_END
