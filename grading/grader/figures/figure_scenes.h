// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace grader {

/// The scenes that figures may show, by the names that the handout gives them.
class FigureScenes {
public:
    /// How a name was understood.
    enum class Fit {
        None,
        Exact,
        Near,    ///< `serapis_emb`, or `cbox` where there is one scene of that beginning
        Variant, ///< `cbox_ems_is`: the scene, rendered in another way or changed
    };

    struct Found {
        Fit fit = Fit::None;
        std::string scene; ///< empty: none
    };

    FigureScenes() = default;

    /// Every scene below `folder`, without reading them.
    /// \param given  the folder holds what students were given; else meshes may stand in for theirs
    /// \throws GraderError  if there is none
    FigureScenes(const std::filesystem::path &folder, bool given);

    /// \param name  FigureName::scene
    Found find(const std::string &name) const;

    std::vector<std::string> names() const;

    /// \param scene  one of names()
    const std::filesystem::path &file(const std::string &scene) const { return m_files.at(scene); }

    bool given() const { return m_given; }

private:
    std::map<std::string, std::filesystem::path> m_files;
    bool m_given = false;
};

} // namespace grader
