// SPDX-License-Identifier: MIT
#include <grader/submission/archive_reader.h>
#include <grader/submission/clutter.h>
#include <grader/submission/names.h>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <memory>
#include <utility>

namespace grader {

namespace {

constexpr std::size_t kBlockBytes = 1U << 16U;

/// Makes this thread's locale UTF-8: in the C locale libarchive gives no name at all for entries
/// that are marked as UTF-8.
class Utf8Locale {
public:
    Utf8Locale() : m_locale(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
        if (m_locale == nullptr) {
            throw GraderError("the locale C.UTF-8 is missing on this machine: names in archives "
                              "cannot be read; install the package libc-bin");
        }
        m_before = uselocale(m_locale);
    }

    ~Utf8Locale() {
        uselocale(m_before);
        freelocale(m_locale);
    }

    Utf8Locale(const Utf8Locale &) = delete;
    Utf8Locale &operator=(const Utf8Locale &) = delete;
    Utf8Locale(Utf8Locale &&) = delete;
    Utf8Locale &operator=(Utf8Locale &&) = delete;

private:
    locale_t m_locale;
    locale_t m_before = nullptr;
};

struct FreeArchive {
    void operator()(archive *handle) const { archive_read_free(handle); }
};

using ArchiveHandle = std::unique_ptr<archive, FreeArchive>;

/// Only formats and filters that read the archive and nothing else: libarchive's `all` includes
/// mtree, whose entries name files of this machine, and filters that start programs.
ArchiveHandle newHandle() {
    ArchiveHandle handle(archive_read_new());
    archive_read_support_format_zip(handle.get());
    archive_read_support_format_tar(handle.get());
    archive_read_support_format_7zip(handle.get());
    archive_read_support_format_rar(handle.get());
    archive_read_support_format_rar5(handle.get());
    archive_read_support_filter_gzip(handle.get());
    archive_read_support_filter_bzip2(handle.get());
    archive_read_support_filter_xz(handle.get());
    archive_read_support_filter_zstd(handle.get());
    return handle;
}

const char *errorText(archive *handle) {
    const char *text = archive_error_string(handle);
    return text != nullptr ? text : "unknown error";
}

GraderError noArchive(const std::string &label, const std::string &why) {
    return GraderError(fmt::format("{}: not an archive that can be read ({}); expected a zip (tar, "
                                   "7z and rar are read too): is the upload complete?",
                                   label, why));
}

/// One pass over an archive.
class Reading {
public:
    Reading(archive *handle, std::string label, std::uint64_t packedBytes, ReadBudget &budget)
        : m_handle(handle),
          m_label(std::move(label)),
          m_packedBytes(packedBytes),
          m_budget(budget) {}

    RawFiles run();

private:
    bool readHeader(archive_entry *&entry);
    void readEntry(archive_entry *entry);
    std::string refusal(archive_entry *entry, const std::string &path) const;
    /// The file's bytes, or in `refused` why there are none.
    RawFile readData(const std::string &path);
    void drain(const std::string &path);
    void refuse(const std::string &path, const std::string &reason);
    void throwIfNothingWasRead() const;

    archive *m_handle;
    std::string m_label;
    std::uint64_t m_packedBytes;
    ReadBudget &m_budget;
    std::uint64_t m_unpackedBytes = 0;
    std::size_t m_encrypted = 0;
    std::string m_damage;
    LeftOutFolders m_leftOut;
    RawFiles m_result;
};

RawFiles Reading::run() {
    archive_entry *entry = nullptr;
    while (readHeader(entry)) {
        m_budget.countEntry();
        readEntry(entry);
    }
    finishFiles(m_result, m_leftOut);
    throwIfNothingWasRead();
    if (!m_damage.empty()) {
        m_result.notes.push_back({Note::Level::Human, m_label,
                                  fmt::format("The archive is damaged or cut short ({}): files "
                                              "after the ones listed may be missing.",
                                              m_damage)});
    }
    return std::move(m_result);
}

bool Reading::readHeader(archive_entry *&entry) {
    for (;;) {
        switch (archive_read_next_header(m_handle, &entry)) {
        case ARCHIVE_OK:
        case ARCHIVE_WARN:
            return true;
        case ARCHIVE_EOF:
            return false;
        case ARCHIVE_RETRY:
            m_budget.countEntry(); // or a hostile archive could keep us here
            break;
        default:
            m_damage = errorText(m_handle);
            return false;
        }
    }
}

std::string Reading::refusal(archive_entry *entry, const std::string &path) const {
    if (archive_entry_hardlink(entry) != nullptr || archive_entry_filetype(entry) == AE_IFLNK) {
        return "is a link";
    }
    if (archive_entry_filetype(entry) != AE_IFREG) {
        return "is a device or another special file";
    }
    if (archive_entry_is_encrypted(entry) != 0) {
        return "is encrypted";
    }
    return pathFault(path);
}

void Reading::readEntry(archive_entry *entry) {
    const char *name = archive_entry_pathname(entry);
    if (name == nullptr) {
        name = archive_entry_pathname_utf8(entry);
    }
    std::string path = name != nullptr ? name : "";
    std::replace(path.begin(), path.end(), '\\', '/');
    while (path.substr(0, 2) == "./") {
        path.erase(0, 2);
    }
    if (archive_entry_filetype(entry) == AE_IFDIR || (!path.empty() && path.back() == '/')) {
        return;
    }
    if (m_leftOut.take(path)) {
        drain(path);
        return;
    }
    m_budget.countFile();
    if (const std::string reason = refusal(entry, path); !reason.empty()) {
        m_encrypted += archive_entry_is_encrypted(entry) != 0 ? 1U : 0U;
        refuse(path, reason);
        return;
    }
    RawFile file = readData(path);
    if (!file.refused.empty()) {
        refuse(path, file.refused);
        return;
    }
    m_budget.countKeptBytes(file.bytes.size());
    m_result.files.push_back(std::move(file));
}

RawFile Reading::readData(const std::string &path) {
    RawFile file{path, "", ""};
    std::array<char, kBlockBytes> block{};
    for (;;) {
        const la_ssize_t size = archive_read_data(m_handle, block.data(), block.size());
        if (size == 0) {
            return file;
        }
        if (size < 0) {
            file.refused = fmt::format("is damaged ({})", errorText(m_handle));
            return file;
        }
        m_unpackedBytes += static_cast<std::uint64_t>(size);
        m_budget.checkTime();
        m_budget.checkRatio(m_unpackedBytes, m_packedBytes, shortened(path));
        if (file.refused.empty()) {
            file.bytes.append(block.data(), static_cast<std::size_t>(size));
        }
        if (file.bytes.size() > m_budget.limits().fileBytes) {
            file.bytes.clear();
            file.refused =
                fmt::format("is larger than {} MiB",
                            m_budget.limits().fileBytes >> 20U); // the rest is passed over
        }
    }
}

/// Reads and forgets: skipping would unpack just the same in a solid archive, but out of reach of
/// the limits.
void Reading::drain(const std::string &path) {
    std::array<char, kBlockBytes> block{};
    la_ssize_t size = 0;
    while ((size = archive_read_data(m_handle, block.data(), block.size())) > 0) {
        m_unpackedBytes += static_cast<std::uint64_t>(size);
        m_budget.checkTime();
        m_budget.checkRatio(m_unpackedBytes, m_packedBytes, shortened(path));
    }
}

void Reading::refuse(const std::string &path, const std::string &reason) {
    m_result.files.push_back({path, "", reason});
}

void Reading::throwIfNothingWasRead() const {
    const bool anyRead = std::any_of(m_result.files.begin(), m_result.files.end(),
                                     [](const RawFile &file) { return file.refused.empty(); });
    if (anyRead) {
        return;
    }
    if (m_encrypted > 0 || archive_read_has_encrypted_entries(m_handle) > 0) {
        throw GraderError(
            fmt::format("{}: the archive is encrypted; ask for one without a password", m_label));
    }
    if (!m_damage.empty()) {
        throw noArchive(m_label, m_damage);
    }
}

} // namespace

bool isArchiveName(std::string_view name) {
    static constexpr std::array<const char *, 9> kExtensions{".zip", ".7z",  ".rar", ".tar", ".tgz",
                                                             ".gz",  ".bz2", ".xz",  ".zst"};
    const std::string extension = splitPath(name).extension;
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

RawFiles readArchiveFile(const std::filesystem::path &path, ReadBudget &budget) {
    const Utf8Locale locale;
    const ArchiveHandle handle = newHandle();
    const std::string label = path.filename().string();
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (error) {
        throw GraderError(fmt::format("{}: {}", path.string(), error.message()));
    }
    if (size == 0) {
        throw GraderError(
            fmt::format("{}: the file is empty (0 bytes); ask for a new upload", path.string()));
    }
    if (archive_read_open_filename(handle.get(), path.c_str(), kBlockBytes) != ARCHIVE_OK) {
        throw noArchive(path.string(), errorText(handle.get()));
    }
    return Reading(handle.get(), label, size, budget).run();
}

RawFiles readArchiveBytes(std::string_view bytes, const std::string &label, ReadBudget &budget) {
    const Utf8Locale locale;
    const ArchiveHandle handle = newHandle();
    if (bytes.empty()) {
        throw GraderError(fmt::format("{}: the file is empty (0 bytes)", label));
    }
    if (archive_read_open_memory(handle.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) {
        throw noArchive(label, errorText(handle.get()));
    }
    return Reading(handle.get(), label, bytes.size(), budget).run();
}

} // namespace grader
