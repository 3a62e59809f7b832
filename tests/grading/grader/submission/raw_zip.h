// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Zips that no archiver writes.
namespace grader::test {

/// What the headers of an entry say, be it true or not.
struct ZipEntry {
    std::string name = {};
    std::string bytes = {};       ///< stored as they are
    std::uint16_t method = 0;     ///< stored
    std::uint16_t flags = 0;      ///< 1: encrypted, 0x800: the name is UTF-8
    std::int64_t size = -1;       ///< claimed size; -1: the true one
    std::int64_t crc = -1;        ///< claimed sum; -1: the true one
    std::uint32_t unixMode = 0;   ///< 0120777: a symbolic link
    std::string centralName = {}; ///< empty: as in the local header
    std::string extra = {};       ///< extra fields of both headers
    int localOf = -1;             ///< shares the local header of an earlier entry
};

inline std::uint32_t crcOf(const std::string &bytes) {
    std::uint32_t crc = 0xffffffffU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1U ^ (0xedb88320U & (0U - (crc & 1U)));
    }
    return ~crc;
}

/// Little-endian numbers one after another.
class ZipBytes {
public:
    ZipBytes &put(std::uint64_t value, int size) {
        for (int i = 0; i < size; ++i)
            m_bytes += static_cast<char>(value >> (8U * static_cast<unsigned>(i)) & 0xffU);
        return *this;
    }

    ZipBytes &put(const std::string &text) {
        m_bytes += text;
        return *this;
    }

    std::string take() { return std::move(m_bytes); }

private:
    std::string m_bytes;
};

/// \param count  entries that the end record claims; -1: the true number
inline std::string rawZip(const std::vector<ZipEntry> &entries, int count = -1,
                          const std::string &comment = "") {
    std::string zip;
    std::vector<std::uint64_t> offsets;
    const auto common = [](ZipBytes &bytes, const ZipEntry &entry, const std::string &name) {
        const auto size =
            entry.size < 0 ? entry.bytes.size() : static_cast<std::uint64_t>(entry.size);
        bytes.put(20, 2).put(entry.flags, 2).put(entry.method, 2).put(0, 4);
        bytes.put(entry.crc < 0 ? crcOf(entry.bytes) : static_cast<std::uint64_t>(entry.crc), 4);
        bytes.put(size, 4).put(size, 4).put(name.size(), 2).put(entry.extra.size(), 2);
    };
    for (const ZipEntry &entry : entries) {
        if (entry.localOf >= 0) {
            offsets.push_back(offsets[static_cast<std::size_t>(entry.localOf)]);
            continue;
        }
        offsets.push_back(zip.size());
        ZipBytes local;
        local.put("PK\x03\x04");
        common(local, entry, entry.name);
        zip += local.put(entry.name).put(entry.extra).put(entry.bytes).take();
    }
    const std::size_t start = zip.size();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const ZipEntry &entry = entries[i];
        const std::string &name = entry.centralName.empty() ? entry.name : entry.centralName;
        ZipBytes central;
        central.put("PK\x01\x02").put(0x031e, 2); // written on Unix
        common(central, entry, name);
        central.put(0, 2).put(0, 2).put(0, 2).put(std::uint64_t{entry.unixMode} << 16U, 4);
        zip += central.put(offsets[i], 4).put(name).put(entry.extra).take();
    }
    const auto claimed =
        static_cast<std::uint64_t>(count < 0 ? static_cast<int>(entries.size()) : count);
    ZipBytes end;
    end.put("PK\x05\x06").put(0, 4).put(claimed, 2).put(claimed, 2);
    end.put(zip.size() - start, 4).put(start, 4).put(comment.size(), 2).put(comment);
    return zip + end.take();
}

} // namespace grader::test
