// SPDX-License-Identifier: MIT
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace calibration {

/// A folder of its own to work in: the probe writes its scene below the working folder.
class WorkFolder {
public:
    WorkFolder() : m_before(std::filesystem::current_path()) {
        std::string name =
            (std::filesystem::temp_directory_path() / "scene-calibration-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::runtime_error(name + ": cannot be made");
        m_path = name;
        std::filesystem::current_path(m_path);
    }

    WorkFolder(const WorkFolder &) = delete;
    WorkFolder(WorkFolder &&) = delete;
    WorkFolder &operator=(const WorkFolder &) = delete;
    WorkFolder &operator=(WorkFolder &&) = delete;

    ~WorkFolder() {
        std::error_code ignored;
        std::filesystem::current_path(m_before, ignored);
        std::filesystem::remove_all(m_path, ignored);
    }

private:
    std::filesystem::path m_before;
    std::filesystem::path m_path;
};

} // namespace calibration
