// SPDX-License-Identifier: MIT
#include "figure_scenes.h"

#include <grader/error.h>
#include <grader/rubric/nearest_name.h>
#include <grader/submission/figure_name.h>

#include <fmt/core.h>

namespace grader {

namespace {

bool startsWith(const std::string &text, const std::string &start) {
    return text.compare(0, start.size(), start) == 0;
}

} // namespace

FigureScenes::FigureScenes(const std::filesystem::path &folder, bool given) : m_given(given) {
    namespace fs = std::filesystem;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->path().extension() == ".xml")
            m_files[parseFigureName(it->path().stem().string()).scene] = it->path();
    }
    if (error || m_files.empty())
        throw GraderError(fmt::format("{}: holds no scene", folder.string()));
}

FigureScenes::Found FigureScenes::find(const std::string &name) const {
    if (name.empty())
        return {};
    if (m_files.count(name) != 0)
        return {Fit::Exact, name};
    std::string longest; // of the scenes that the name begins with
    std::vector<std::string> longer;
    for (const auto &[scene, file] : m_files) {
        if (startsWith(name, scene + "_") && scene.size() > longest.size())
            longest = scene;
        if (startsWith(scene, name + "_"))
            longer.push_back(scene);
    }
    if (!longest.empty())
        return {Fit::Variant, longest};
    if (longer.size() == 1)
        return {Fit::Near, longer.front()};
    const std::string nearest = nearestName(name, names());
    return nearest.empty() ? Found{} : Found{Fit::Near, nearest};
}

std::vector<std::string> FigureScenes::names() const {
    std::vector<std::string> names;
    names.reserve(m_files.size());
    for (const auto &[scene, file] : m_files)
        names.push_back(scene);
    return names;
}

} // namespace grader
