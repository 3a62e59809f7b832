// SPDX-License-Identifier: MIT
#include "text_file.h"

#include <grader/error.h>

#include <fmt/core.h>

#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>

namespace grader {

std::string readTextFile(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text;
    for (std::array<char, 65536> block{}; stream;) {
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (!stream.is_open() || stream.bad())
        throw GraderError(fmt::format("{}: cannot be read", file.string()));
    return text;
}

void writeTextFile(const std::filesystem::path &file, std::string_view bytes) {
    static std::atomic<unsigned> counter{0};
    std::filesystem::path temporary = file;
    temporary += fmt::format(".{}-{}", getpid(), counter++);
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    const bool written = !stream.fail();
    using std::filesystem::perms;
    if (written) {
        std::filesystem::permissions(temporary, perms::others_read | perms::group_read,
                                     std::filesystem::perm_options::add, error);
        std::filesystem::rename(temporary, file, error);
    }
    if (!written || error) {
        const std::string reason =
            written ? error.message() : "is the disk full, or the folder someone else's?";
        std::filesystem::remove(temporary, error);
        throw GraderError(fmt::format("{}: cannot be written: {}", file.string(), reason));
    }
}

} // namespace grader
