// SPDX-License-Identifier: MIT
#include "image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace {

using nori::NoriException;

/// A name in the same folder that is removed unless the file is put in its place.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string &finalStem, const char *suffix)
        : m_final(finalStem + suffix),
          m_stem(finalStem + ".writing-" + std::to_string(::getpid())),
          m_name(m_stem + suffix) {}

    ~TemporaryFile() { std::remove(m_name.c_str()); }

    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    const std::string &stem() const { return m_stem; }

    const std::string &name() const { return m_name; }

    const std::string &finalName() const { return m_final; }

    void putInPlace() const {
        if (std::rename(m_name.c_str(), m_final.c_str()) != 0)
            throw NoriException("%s: cannot be written: %s", m_final, std::strerror(errno));
    }

private:
    std::string m_final;
    std::string m_stem;
    std::string m_name;
};

/// Planes of floats with the names of their channels.
class Planes {
public:
    Planes(int width, int height) : m_width(width), m_height(height) {}

    std::vector<float> &add(const std::string &name) {
        std::vector<float> &plane = m_planes[name];
        plane.resize(static_cast<size_t>(m_width) * static_cast<size_t>(m_height));
        return plane;
    }

    /// The file's bytes.
    std::string encode(const std::map<std::string, std::string> &attributes) {
        Imf::Header header(m_width, m_height);
        for (const auto &attribute : attributes)
            header.insert(attribute.first, Imf::StringAttribute(attribute.second));
        Imf::FrameBuffer buffer;
        for (auto &plane : m_planes) {
            header.channels().insert(plane.first, Imf::Channel(Imf::FLOAT));
            buffer.insert(plane.first,
                          Imf::Slice(Imf::FLOAT, reinterpret_cast<char *>(plane.second.data()),
                                     sizeof(float), sizeof(float) * static_cast<size_t>(m_width)));
        }
        Imf::StdOSStream stream;
        {
            Imf::OutputFile output(stream, header);
            output.setFrameBuffer(buffer);
            output.writePixels(m_height);
        } // writes the table of lines
        return stream.str();
    }

private:
    int m_width;
    int m_height;
    std::map<std::string, std::vector<float>> m_planes;
};

/// OpenEXR's own files lose the errors of the last bytes, which are written when they are closed.
/// \throws std::system_error
void writeBytes(const std::string &name, const std::string &bytes) {
    const auto check = [](bool good) {
        if (!good)
            throw std::system_error(errno, std::generic_category());
    };
    FILE *const file = std::fopen(name.c_str(), "wb");
    check(file != nullptr);
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() &&
                         std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0;
    const int error = errno;
    const bool closed = std::fclose(file) == 0;
    errno = written ? errno : error;
    check(written && closed);
}

constexpr const char *kChannels[] = {"R", "G", "B"};

void writeExr(const nori::RenderResult &result, const TemporaryFile &file,
              const std::map<std::string, std::string> &header) {
    const auto height = static_cast<int>(result.image.rows());
    const auto width = static_cast<int>(result.image.cols());
    Planes planes(width, height);
    for (int c = 0; c < 3; ++c) {
        std::vector<float> &plane = planes.add(kChannels[c]);
        for (Eigen::Index i = 0; i < result.image.size(); ++i)
            plane[static_cast<size_t>(i)] = result.image.data()[i][c];
    }
    if (!result.moments.empty()) {
        std::vector<float> &count = planes.add("count.Y");
        for (size_t i = 0; i < count.size(); ++i)
            count[i] = static_cast<float>(result.moments[i].count);
        for (size_t c = 0; c < 3; ++c) {
            std::vector<float> &mean = planes.add(std::string("mean.") + kChannels[c]);
            std::vector<float> &variance = planes.add(std::string("variance.") + kChannels[c]);
            std::vector<float> &third = planes.add(std::string("third.") + kChannels[c]);
            for (size_t i = 0; i < variance.size(); ++i) {
                mean[i] = static_cast<float>(result.moments[i].mean[c]);
                variance[i] = static_cast<float>(result.moments[i].variance[c]);
                third[i] = static_cast<float>(result.moments[i].thirdCentral[c]);
            }
        }
    }
    try {
        writeBytes(file.name(), planes.encode(header));
    } catch (const std::system_error &error) {
        throw NoriException("%s: cannot be written: %s", file.finalName(), error.code().message());
    }
}

} // namespace

void requireWritable(const std::string &stem) {
    const std::filesystem::path path = stem;
    const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
    if (!path.has_filename() || path.filename() == "." || path.filename() == "..")
        throw NoriException("%s: is a folder; the name of the image without suffix is expected",
                            stem);
    for (const char *suffix : {".exr", ".png"}) {
        if (std::filesystem::is_directory(stem + suffix))
            throw NoriException("%s%s: cannot be written: it is a folder", stem, suffix);
    }
    if (!std::filesystem::is_directory(folder))
        throw NoriException("%s: cannot be written: there is no folder %s", stem, folder);
    const TemporaryFile probe(stem, ".exr");
    try {
        writeBytes(probe.name(), "");
    } catch (const std::system_error &error) {
        throw NoriException("%s: cannot be written: %s", probe.finalName(), error.code().message());
    }
}

void writeImage(const nori::RenderResult &result, const std::string &stem,
                const std::map<std::string, std::string> &header) {
    const TemporaryFile exr(stem, ".exr");
    const TemporaryFile png(stem, ".png");
    writeExr(result, exr, header);
    result.image.savePNG(png.stem());
    exr.putInPlace();
    png.putInPlace();
}
