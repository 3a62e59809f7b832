// SPDX-License-Identifier: MIT
#include "text_file.h"

#include <grader/error.h>

#include <fmt/core.h>

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iterator>

namespace grader {

std::string readTextFile(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream)
        throw GraderError(fmt::format("{}: cannot be read", file.string()));
    return text;
}

void writeTextFile(const std::filesystem::path &file, std::string_view bytes) {
    static std::atomic<unsigned> counter{0};
    std::filesystem::path temporary = file;
    temporary += fmt::format(".{}-{}", getpid(), counter++);
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    {
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        stream.close();
        if (!stream) {
            std::filesystem::remove(temporary, error);
            throw GraderError(fmt::format("{}: cannot be written; is the disk full, or the folder "
                                          "someone else's?",
                                          file.string()));
        }
    }
    using std::filesystem::perms;
    std::filesystem::permissions(temporary, perms::others_read | perms::group_read,
                                 std::filesystem::perm_options::add);
    std::filesystem::rename(temporary, file);
}

} // namespace grader
