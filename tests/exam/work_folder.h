// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

#include "expectation.h"

namespace exam {

/// A folder that is removed at the end.
class WorkFolder {
public:
    WorkFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "norigrade-exam-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw ExamError(name + ": cannot be made");
        m_path = name;
    }

    WorkFolder(const WorkFolder &) = delete;
    WorkFolder(WorkFolder &&) = delete;
    WorkFolder &operator=(const WorkFolder &) = delete;
    WorkFolder &operator=(WorkFolder &&) = delete;

    ~WorkFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }

    const std::filesystem::path &path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

} // namespace exam
