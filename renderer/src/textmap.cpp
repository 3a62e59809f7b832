// SPDX-License-Identifier: MIT
#include <nori/bitmap.h>
#include <nori/texture.h>

#include <filesystem/resolver.h>

NORI_NAMESPACE_BEGIN

/// PNG or JPEG image times a colour. Its bytes are taken as linear values, as in Nori 2.
class TextureMap : public Texture {
public:
    TextureMap(const PropertyList &props)
        : m_filename(props.getString("filename")),
          m_bitmap(getFileResolver()->resolve(m_filename).str()),
          m_color(props.getColor("color", Color3f(1.0f))) {
        // Nori 2 accepts a scale and does not use it; scenes that carry one must look the same.
        // Both are read in any case: a property that nothing reads is unknown to the parser.
        const float scaleX = props.getFloat("scalex", 1.0f);
        const float scaleY = props.getFloat("scaley", 1.0f);
        if (scaleX != 1.0f || scaleY != 1.0f)
            cerr << "textmap: scalex and scaley have no effect, as in Nori 2\n";
    }

    Color3f eval(const Point2f &uv) const override { return m_bitmap.eval(uv) * m_color; }

    std::string toString() const override {
        return tfm::format("TextureMap[\n"
                           "  filename = \"%s\",\n"
                           "  color = %s\n"
                           "]",
                           m_filename, m_color.toString());
    }

private:
    std::string m_filename;
    LDRBitmap m_bitmap;
    Color3f m_color;
};

NORI_REGISTER_CLASS(TextureMap, "textmap")

NORI_NAMESPACE_END
