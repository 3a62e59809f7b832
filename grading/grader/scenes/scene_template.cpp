// SPDX-License-Identifier: MIT
#include "scene_template.h"

#include <grader/error.h>
#include <grader/scenes/test_mesh.h>
#include <grader/scenes/test_scene.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <sstream>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr double kPoseReach = 1.5;
constexpr char kRadiance[] = "{radiance ";

std::string triple(const Vector3d &v) {
    return fmt::format("{:.9g}, {:.9g}, {:.9g}", v.x(), v.y(), v.z());
}

Vector3d vectorAt(const std::vector<double> &numbers, std::size_t at) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

/// A placeholder taken apart: `{mesh sphere 0 0 1 0.5}`.
struct Placeholder {
    std::string word;            ///< `mesh`
    std::string kind;            ///< `sphere`; the name of a file
    std::vector<double> numbers; ///< 0, 0, 1, 0.5
};

/// \return  nothing if what stands in the braces is no words and numbers
std::optional<Placeholder> takeApart(const std::string &inside) {
    std::istringstream stream(inside);
    Placeholder result;
    if (!(stream >> result.word))
        return std::nullopt;
    if ((result.word == "mesh" || result.word == "file") && !(stream >> result.kind))
        return std::nullopt;
    double number = 0;
    while (stream >> number)
        result.numbers.push_back(number);
    if (!stream.eof())
        return std::nullopt;
    return result;
}

/// One filling: draws all that is random, in the order of the text.
class Filling {
public:
    Filling(const fs::path &file, std::uint64_t seed, const SceneVariation &variation,
            std::string folder)
        : m_file(file),
          m_variation(variation),
          m_folder(std::move(folder)),
          m_random(seed),
          m_cuts(statistics::mix64(seed)) {
        SceneRandom pose(statistics::deriveSeed(seed, "pose", 0, variation.pose));
        m_pose = pose.rigid(kPoseReach);
    }

    /// \return  nothing if there is no such placeholder
    std::optional<std::string> replace(const Placeholder &what) {
        const std::size_t count = what.numbers.size();
        if (what.word == "number" && count == 2)
            return fmt::format("{:.9g}", m_random.uniform(what.numbers[0], what.numbers[1]));
        if (what.word == "color" && count == 2)
            return triple(m_random.color(what.numbers[0], what.numbers[1]));
        if (what.word == "radiance" && count == 2)
            return triple(radiance(what.numbers[0], what.numbers[1]));
        if (what.word == "point" && count == 4)
            return triple(m_pose * (vectorAt(what.numbers, 0) +
                                    m_random.color(-what.numbers[3], what.numbers[3])));
        if (what.word == "direction" && count == 3)
            return triple(m_pose.linear() * vectorAt(what.numbers, 0));
        if (what.word == "mesh")
            return mesh(what);
        if (what.word == "file" && count == 0) {
            const std::string name = fs::path(what.kind).filename().string();
            add(name, readTextFile(m_file.parent_path() / what.kind));
            return name;
        }
        return std::nullopt;
    }

    std::vector<protocol::File> finish(std::string xml) {
        m_files.insert(m_files.begin(), {path(TestScene::kFileName), std::move(xml)});
        return std::move(m_files);
    }

private:
    std::string path(const std::string &name) const {
        return m_folder.empty() ? name : m_folder + "/" + name;
    }

    void add(const std::string &name, std::string bytes) {
        m_files.push_back({path(name), std::move(bytes)});
    }

    Vector3d radiance(double low, double high) {
        const Vector3d color = m_random.color(low, high);
        const auto &dark = m_variation.darkLights;
        const bool isDark = std::find(dark.begin(), dark.end(), m_lights++) != dark.end();
        return isDark ? Vector3d::Zero() : (m_variation.radianceFactor * color).eval();
    }

    std::optional<std::string> mesh(const Placeholder &what) {
        // Two to three pieces per side, of unequal widths: a light must be sampled by area.
        const int cuts = 1 + static_cast<int>(m_cuts.nextBelow(2)) + m_variation.cuts;
        const std::vector<double> &n = what.numbers;
        TestMesh mesh;
        if (what.kind == "parallelogram" && n.size() == 9)
            mesh = patch(vectorAt(n, 0), vectorAt(n, 3), vectorAt(n, 6), cuts, m_cuts);
        else if (what.kind == "block" && n.size() == 7)
            mesh = block(vectorAt(n, 0), vectorAt(n, 3), n[6] * std::numbers::pi / 180);
        else if (what.kind == "sphere" && n.size() == 4)
            mesh = sphere(vectorAt(n, 0), n[3], 12);
        else
            return std::nullopt;
        const std::string name = fmt::format("mesh{}.obj", m_meshes++);
        add(name, mesh.transformed(m_pose).toObj());
        return name;
    }

    const fs::path &m_file;
    const SceneVariation &m_variation;
    std::string m_folder;
    SceneRandom m_random;
    SceneRandom m_cuts; ///< of its own: how often meshes are cut must change nothing else
    Eigen::Isometry3d m_pose;
    std::vector<protocol::File> m_files;
    std::size_t m_lights = 0;
    int m_meshes = 0;
};

} // namespace

SceneTemplate::SceneTemplate(fs::path file)
    : m_file(std::move(file)), m_text(readTextFile(m_file)) {}

SceneTemplate::SceneTemplate(fs::path name, std::string text)
    : m_file(std::move(name)), m_text(std::move(text)) {}

std::vector<protocol::File> SceneTemplate::fill(std::uint64_t seed, const SceneVariation &variation,
                                                const std::string &folder) const {
    Filling filling(m_file, seed, variation, folder);
    std::string xml;
    std::size_t at = 0;
    for (std::size_t open = m_text.find('{'); open != std::string::npos;
         open = m_text.find('{', at)) {
        xml += m_text.substr(at, open - at);
        const std::size_t close = m_text.find('}', open);
        const std::string inside = m_text.substr(open + 1, close - open - 1);
        const auto placeholder = close == std::string::npos ? std::nullopt : takeApart(inside);
        const auto text = placeholder ? filling.replace(*placeholder) : std::nullopt;
        if (!text)
            throw GraderError(fmt::format(
                "{}:{}: there is no placeholder {{{}}}", m_file.string(),
                1 + std::count(m_text.begin(), m_text.begin() + static_cast<long>(open), '\n'),
                inside.substr(0, inside.find('\n'))));
        xml += *text;
        at = close + 1;
    }
    return filling.finish(xml + m_text.substr(at));
}

std::size_t SceneTemplate::lightCount() const {
    std::size_t count = 0;
    for (std::size_t at = m_text.find(kRadiance); at != std::string::npos;
         at = m_text.find(kRadiance, at + 1))
        ++count;
    return count;
}

} // namespace grader
