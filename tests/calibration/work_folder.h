// SPDX-License-Identifier: MIT
#pragma once

#include <support/work_folder.h>

#include <filesystem>

namespace calibration {

/// A folder of its own to work in: the probe writes its scene below the working folder.
class WorkFolder {
public:
    WorkFolder() { std::filesystem::current_path(m_folder.path()); }

    ~WorkFolder() {
        std::error_code ignored;
        std::filesystem::current_path(m_before, ignored);
    }

    WorkFolder(const WorkFolder &) = delete;
    WorkFolder(WorkFolder &&) = delete;
    WorkFolder &operator=(const WorkFolder &) = delete;
    WorkFolder &operator=(WorkFolder &&) = delete;

private:
    std::filesystem::path m_before = std::filesystem::current_path();
    support::WorkFolder m_folder; ///< goes after its leaving
};

} // namespace calibration
