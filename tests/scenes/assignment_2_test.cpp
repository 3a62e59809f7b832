// SPDX-License-Identifier: MIT
#include <Imath/ImathBox.h>
#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path kScenes = fs::path(NORI_SOURCE_DIR) / "scenes" / "assignment-2";

/// Every scene below kScenes, relative to it, sorted.
std::vector<std::string> sceneFiles() {
    std::vector<std::string> files;
    for (const auto &entry : fs::recursive_directory_iterator(kScenes))
        if (entry.path().extension() == ".xml")
            files.push_back(entry.path().lexically_relative(kScenes).string());
    std::sort(files.begin(), files.end());
    return files;
}

/// A fresh folder that goes with this object.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (fs::temp_directory_path() / "nori_scenes_XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw fs::filesystem_error("mkdtemp", pattern, {errno, std::generic_category()});
        m_path = pattern;
    }

    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }

    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;
    TemporaryFolder(TemporaryFolder &&) = delete;
    TemporaryFolder &operator=(TemporaryFolder &&) = delete;

    const fs::path &path() const { return m_path; }

private:
    fs::path m_path;
};

/// Red, green and blue of an EXR, shape [height * width * 3].
struct Image {
    int width = 0, height = 0;
    std::vector<double> values;

    double at(int x, int y, int channel) const {
        return values.at((static_cast<std::size_t>(y) * width + x) * 3 + channel);
    }
};

Image loadExr(const fs::path &path) {
    Imf::RgbaInputFile file(path.c_str());
    const Imath::Box2i window = file.dataWindow();
    Image image{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, {}};
    Imf::Array2D<Imf::Rgba> pixels(image.height, image.width);
    file.setFrameBuffer(&pixels[0][0] - window.min.x -
                            static_cast<std::ptrdiff_t>(window.min.y) * image.width,
                        1, image.width);
    file.readPixels(window.min.y, window.max.y);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (const float value : {pixels[y][x].r, pixels[y][x].g, pixels[y][x].b})
                image.values.push_back(static_cast<double>(value));
    return image;
}

/// Renders a scene with `nori` into `folder`, which holds nothing but the result afterwards.
///
/// \return exit status of the program, or -1 if it did not end by itself
int render(const std::string &scene, int spp, const fs::path &folder) {
    const std::string command = std::string("'" NORI_PROGRAM "' '") + (kScenes / scene).string() +
                                "' --no-gui --quiet --spp " + std::to_string(spp) + " --output '" +
                                (folder / "image").string() + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The one file in `folder` with this extension; empty if there is none or there are several.
fs::path onlyFile(const fs::path &folder, const std::string &extension) {
    std::vector<fs::path> found;
    for (const auto &entry : fs::directory_iterator(folder))
        if (entry.path().extension() == extension)
            found.push_back(entry.path());
    return found.size() == 1 ? found.front() : fs::path();
}

Image renderToImage(const std::string &scene, int spp) {
    const TemporaryFolder folder;
    EXPECT_EQ(render(scene, spp, folder.path()), 0) << scene;
    return loadExr(onlyFile(folder.path(), ".exr"));
}

/// Mean of `a - factor * b` over an image in units of its standard error, taken from blocks of
/// 32 x 32 pixels: wide beside the filter (radius 2), so that their means are nearly independent.
double differenceInStandardErrors(const Image &a, const Image &b, double factor) {
    constexpr int kBlock = 32;
    std::vector<double> blocks;
    for (int top = 0; top + kBlock <= a.height; top += kBlock) {
        for (int left = 0; left + kBlock <= a.width; left += kBlock) {
            double sum = 0.0;
            for (int y = top; y < top + kBlock; ++y)
                for (int x = left; x < left + kBlock; ++x)
                    for (int channel = 0; channel < 3; ++channel)
                        sum += a.at(x, y, channel) - factor * b.at(x, y, channel);
            blocks.push_back(sum);
        }
    }
    double sum = 0.0;
    double squares = 0.0;
    for (const double block : blocks) {
        sum += block;
        squares += block * block;
    }
    return sum / std::sqrt(squares); // under a mean of 0, squares estimates the variance of sum
}

std::string testName(const testing::TestParamInfo<std::string> &scene) {
    std::string name = fs::path(scene.param).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

class EverySceneOfAssignment2 : public testing::TestWithParam<std::string> {};

TEST_P(EverySceneOfAssignment2, RendersAnImageThatIsNotBlack) {
    const TemporaryFolder folder;
    ASSERT_EQ(render(GetParam(), 1, folder.path()), 0);

    const fs::path exr = onlyFile(folder.path(), ".exr");
    const fs::path png = onlyFile(folder.path(), ".png");
    ASSERT_FALSE(exr.empty());
    ASSERT_FALSE(png.empty());
    EXPECT_GT(fs::file_size(png), 1000U);
    const Image image = loadExr(exr);
    const auto lit = std::count_if(image.values.begin(), image.values.end(),
                                   [](double value) { return value > 0.01; });
    // A tenth: the darkest, with one of seven lights per sample and no background, has a quarter.
    EXPECT_GT(static_cast<double>(lit), 0.1 * static_cast<double>(image.values.size()));
    EXPECT_TRUE(std::all_of(image.values.begin(), image.values.end(),
                            [](double value) { return std::isfinite(value) && value >= 0.0; }));
}

INSTANTIATE_TEST_SUITE_P(Scenes, EverySceneOfAssignment2, testing::ValuesIn(sceneFiles()),
                         testName);

/// Two scenes that must converge to the same image.
struct Twins {
    const char *first;
    const char *second;
};

class ScenesThatDifferInSamplingOnly : public testing::TestWithParam<Twins> {};

TEST_P(ScenesThatDifferInSamplingOnly, HaveTheSameMean) {
    const Image first = renderToImage(GetParam().first, 16);
    const Image second = renderToImage(GetParam().second, 16);
    ASSERT_EQ(first.width, second.width);
    ASSERT_EQ(first.height, second.height);

    // 5 standard errors: a right renderer fails with probability 6e-7 over the seeds.
    EXPECT_LT(std::abs(differenceInStandardErrors(first, second, 1.0)), 5.0);
    // The wrong twin: a renderer whose light is 2 % too strong is found out.
    EXPECT_GT(std::abs(differenceInStandardErrors(first, second, 1.02)), 5.0);
}

INSTANTIATE_TEST_SUITE_P(
    Serapis, ScenesThatDifferInSamplingOnly,
    testing::Values(Twins{"serapis/serapis_whitted.xml", "serapis/serapis_ems.xml"},
                    Twins{"serapis/serapis_ems.xml", "serapis/serapis_ems_power.xml"},
                    Twins{"serapis/serapis_env.xml", "serapis/serapis_env_map.xml"}),
    [](const testing::TestParamInfo<Twins> &twins) {
        return fs::path(twins.param.second).stem().string();
    });

} // namespace
