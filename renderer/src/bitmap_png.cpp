// SPDX-License-Identifier: MIT
#include <nori/bitmap.h>

#include <jpeglib.h>
#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>

NORI_NAMESPACE_BEGIN

namespace {

/// Larger files are taken for broken ones [pixels]; 16384^2.
constexpr uint64_t kMaxPixels = uint64_t{1} << 28;

struct FileCloser {
    void operator()(FILE *file) const { fclose(file); }
};

using File = std::unique_ptr<FILE, FileCloser>;

void readPNG(const std::string &filename, LDRBitmap &bitmap) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, filename.c_str()) == 0)
        throw NoriException("%s", image.message);
    if (uint64_t{image.width} * image.height > kMaxPixels) {
        png_image_free(&image);
        throw NoriException("%d x %d pixels are not supported", image.width, image.height);
    }
    // With alpha, which is then left out: libpng would blend it with a background otherwise.
    image.format = PNG_FORMAT_RGBA;
    std::vector<uint8_t> pixels(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0)
        throw NoriException("%s", image.message);
    bitmap.resize(image.height, image.width);
    for (Eigen::Index i = 0; i < bitmap.size(); ++i)
        bitmap.data()[i] = Eigen::Map<const Color3b>(pixels.data() + 4 * i);
}

/// libjpeg's state, with a way out of its error handler, which must not return.
struct JpegReader {
    jpeg_decompress_struct info;
    jpeg_error_mgr errors;
    jmp_buf escape;
    char message[JMSG_LENGTH_MAX];
};

extern "C" void leaveJpegReader(j_common_ptr info) {
    auto *reader = static_cast<JpegReader *>(info->client_data);
    info->err->format_message(info, reader->message);
    longjmp(reader->escape, 1);
}

extern "C" void ignoreJpegMessage(j_common_ptr) {}

/// Between setjmp() and longjmp() there must be no destructors: everything is the caller's.
bool decodeJPEG(JpegReader &reader, FILE *file, std::vector<uint8_t> &pixels) {
    if (setjmp(reader.escape) != 0)
        return false;
    jpeg_stdio_src(&reader.info, file);
    jpeg_read_header(&reader.info, TRUE);
    if (uint64_t{reader.info.image_width} * reader.info.image_height > kMaxPixels) {
        snprintf(reader.message, sizeof reader.message, "%u x %u pixels are not supported",
                 reader.info.image_width, reader.info.image_height);
        return false;
    }
    reader.info.out_color_space = JCS_RGB;
    jpeg_start_decompress(&reader.info);
    const size_t rowBytes = size_t{3} * reader.info.output_width;
    pixels.resize(rowBytes * reader.info.output_height);
    while (reader.info.output_scanline < reader.info.output_height) {
        JSAMPROW row = pixels.data() + rowBytes * reader.info.output_scanline;
        jpeg_read_scanlines(&reader.info, &row, 1);
    }
    if (reader.errors.num_warnings > 0) {
        snprintf(reader.message, sizeof reader.message, "the data is damaged or cut short");
        return false;
    }
    return true;
}

void readJPEG(FILE *file, LDRBitmap &bitmap) {
    auto reader = std::make_unique<JpegReader>();
    reader->info.err = jpeg_std_error(&reader->errors);
    reader->errors.error_exit = leaveJpegReader;
    reader->errors.output_message = ignoreJpegMessage;
    jpeg_create_decompress(&reader->info);
    reader->info.client_data = reader.get();

    std::vector<uint8_t> pixels;
    const bool decoded = decodeJPEG(*reader, file, pixels);
    const unsigned int width = reader->info.output_width;
    const unsigned int height = reader->info.output_height;
    jpeg_destroy_decompress(&reader->info);
    if (!decoded)
        throw NoriException("%s", reader->message);
    bitmap.resize(height, width);
    for (Eigen::Index i = 0; i < bitmap.size(); ++i)
        bitmap.data()[i] = Eigen::Map<const Color3b>(pixels.data() + 3 * i);
}

} // namespace

LDRBitmap::LDRBitmap(const std::string &filename) {
    try {
        const File file(fopen(filename.c_str(), "rb"));
        if (!file)
            throw NoriException("%s", strerror(errno));
        uint8_t magic[8] = {};
        const size_t count = fread(magic, 1, sizeof magic, file.get());
        rewind(file.get());
        if (count == sizeof magic && png_sig_cmp(magic, 0, sizeof magic) == 0)
            readPNG(filename, *this);
        else if (magic[0] == 0xff && magic[1] == 0xd8)
            readJPEG(file.get(), *this);
        else
            throw NoriException("it is neither a PNG nor a JPEG file");
    } catch (const std::exception &error) {
        throw NoriException("Cannot read the image file \"%s\": %s", filename, error.what());
    }
}

void Bitmap::savePNG(const std::string &filename) const {
    const std::string path = filename + ".png";
    const std::string partial = path + ".part"; // renamed when complete
    std::vector<uint8_t> pixels;
    pixels.reserve(3 * static_cast<size_t>(size()));
    for (Eigen::Index i = 0; i < size(); ++i) {
        const Color3f srgb = data()[i].toSRGB();
        for (int channel = 0; channel < 3; ++channel) {
            const float value = 255.0f * srgb[channel];
            pixels.push_back(value > 0.0f ? static_cast<uint8_t>(std::min(value, 255.0f)) : 0);
        }
    }
    try {
        File file(fopen(partial.c_str(), "wb"));
        if (!file)
            throw NoriException("%s", strerror(errno));
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        image.format = PNG_FORMAT_RGB;
        image.width = static_cast<png_uint_32>(cols());
        image.height = static_cast<png_uint_32>(rows());
        if (png_image_write_to_stdio(&image, file.get(), 0, pixels.data(), 0, nullptr) == 0)
            throw NoriException("%s", image.message);
        if (fclose(file.release()) != 0 || std::rename(partial.c_str(), path.c_str()) != 0)
            throw NoriException("%s", strerror(errno));
    } catch (const std::exception &error) {
        std::remove(partial.c_str());
        throw NoriException("Cannot write the PNG file \"%s\": %s", path, error.what());
    }
}

NORI_NAMESPACE_END
