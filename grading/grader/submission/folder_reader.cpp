// SPDX-License-Identifier: MIT
#include <grader/submission/clutter.h>
#include <grader/submission/folder_reader.h>
#include <grader/submission/names.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace grader {

namespace {

namespace fs = std::filesystem;

class Descriptor {
public:
    explicit Descriptor(const fs::path &path)
        // Without O_NONBLOCK, opening a pipe would wait for a writer.
        : m_fd(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)) {}

    ~Descriptor() {
        if (m_fd >= 0) {
            close(m_fd);
        }
    }

    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;
    Descriptor(Descriptor &&) = delete;
    Descriptor &operator=(Descriptor &&) = delete;

    int get() const { return m_fd; }

private:
    int m_fd;
};

std::string errnoText() {
    return std::generic_category().message(errno);
}

/// Reads one file; `refused` is set where it cannot be.
RawFile readFile(const fs::path &path, ReadBudget &budget) {
    RawFile file;
    const Descriptor descriptor(path);

    struct stat info {};

    if (descriptor.get() < 0 || fstat(descriptor.get(), &info) != 0) {
        file.refused = fmt::format("cannot be read ({})", errnoText());
        return file;
    }
    if (!S_ISREG(info.st_mode)) {
        file.refused = "is a device or another special file";
        return file;
    }
    std::array<char, 1U << 16U> block{};
    for (;;) {
        const ssize_t size = read(descriptor.get(), block.data(), block.size());
        if (size == 0) {
            return file;
        }
        if (size < 0) {
            file.refused = fmt::format("cannot be read ({})", errnoText());
            return file;
        }
        budget.checkTime();
        file.bytes.append(block.data(), static_cast<std::size_t>(size));
        if (file.bytes.size() > budget.limits().fileBytes) {
            file.bytes.clear();
            file.refused = fmt::format("is larger than {} MiB", budget.limits().fileBytes >> 20U);
            return file;
        }
    }
}

struct Listing {
    std::vector<std::string> files; ///< relative paths as the disk has them
    std::vector<std::string> links;
    std::vector<Note> notes;
};

void list(const fs::path &root, const std::string &prefix, LeftOutFolders &leftOut,
          ReadBudget &budget, Listing &listing) {
    std::error_code error;
    fs::directory_iterator it(root / prefix, error);
    if (error) {
        if (prefix.empty()) {
            throw GraderError(
                fmt::format("{}: cannot be listed: {}", root.string(), error.message()));
        }
        listing.notes.push_back(
            {Note::Level::Human, prefix,
             fmt::format("The folder '{}' cannot be listed ({}).", prefix, error.message())});
        return;
    }
    for (; it != fs::directory_iterator(); it.increment(error)) {
        budget.countEntry();
        const std::string path = prefix + it->path().filename().string();
        const fs::file_status status = it->symlink_status(error);
        if (fs::is_directory(status)) {
            if (!leftOut.take(path + "/", 0)) {
                list(root, path + "/", leftOut, budget, listing);
            }
        } else if (!leftOut.take(path)) {
            budget.countFile();
            (fs::is_symlink(status) ? listing.links : listing.files).push_back(path);
        }
        if (error) {
            break;
        }
    }
}

} // namespace

RawFiles readFolder(const fs::path &root, ReadBudget &budget) {
    LeftOutFolders leftOut;
    Listing listing;
    list(root, "", leftOut, budget, listing);
    std::sort(listing.files.begin(), listing.files.end());
    std::sort(listing.links.begin(), listing.links.end());

    RawFiles result;
    result.notes = listing.notes;
    for (const std::string &path : listing.files) {
        RawFile file = readFile(root / path, budget);
        file.path = path;
        if (file.refused.empty()) {
            file.refused = pathFault(path);
        }
        budget.countKeptBytes(file.bytes.size());
        result.files.push_back(std::move(file));
    }
    for (const std::string &path : listing.links) {
        result.files.push_back({path, "", "is a link"});
    }
    finishFiles(result, leftOut);
    return result;
}

} // namespace grader
