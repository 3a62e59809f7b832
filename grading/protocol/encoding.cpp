// SPDX-License-Identifier: MIT
#include <protocol/request.h>

#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

namespace protocol {

namespace {

constexpr std::uint32_t kMagic = 0x6e6f7269; // "nori"
constexpr std::uint32_t kVersion = 1;

// Both sides run on one machine: its own byte order and float format are the format.

class Writer {
public:
    template <typename T>
    void put(const T &value) {
        append(&value, sizeof(T));
    }

    void put(const std::string &text) {
        putSize(text.size());
        append(text.data(), text.size());
    }

    void put(const std::vector<float> &values) {
        putSize(values.size());
        append(values.data(), values.size() * sizeof(float));
    }

    void putSize(std::size_t size) {
        if (size > kLargest)
            throwTooLarge();
        put(static_cast<std::uint32_t>(size));
    }

    std::string take() { return std::move(m_bytes); }

private:
    static constexpr std::size_t kLargest = std::numeric_limits<std::uint32_t>::max();

    [[noreturn]] static void throwTooLarge() {
        throw std::length_error("protocol: more than 4 GiB in one request group");
    }

    void append(const void *data, std::size_t size) {
        if (size > kLargest - m_bytes.size())
            throwTooLarge();
        if (size != 0)
            m_bytes.append(static_cast<const char *>(data), size);
    }

    std::string m_bytes;
};

class Reader {
public:
    Reader(const char *data, std::size_t size) : m_at(data), m_left(size) {}

    template <typename T>
    T get() {
        T value;
        std::memcpy(&value, take(sizeof(T)), sizeof(T));
        return value;
    }

    std::string getString() {
        const std::size_t size = get<std::uint32_t>();
        const char *bytes = take(size);
        return std::string(bytes, size);
    }

    std::vector<float> getFloats() {
        const std::size_t count = get<std::uint32_t>();
        // Checked before anything is allocated.
        const char *bytes = take(count * sizeof(float));
        std::vector<float> values(count);
        if (count != 0)
            std::memcpy(values.data(), bytes, count * sizeof(float));
        return values;
    }

    /// A count of things that take at least `minimum` bytes each.
    std::size_t getCount(std::size_t minimum) {
        const std::size_t count = get<std::uint32_t>();
        if (count > m_left / minimum)
            throw std::runtime_error("protocol: a count is larger than the message");
        return count;
    }

    void requireEnd() const {
        if (m_left != 0)
            throw std::runtime_error("protocol: bytes after the end of the message");
    }

private:
    const char *take(std::size_t size) {
        if (size > m_left)
            throw std::runtime_error("protocol: the message ends too early");
        const char *bytes = m_at;
        m_at += size;
        m_left -= size;
        return bytes;
    }

    const char *m_at;
    std::size_t m_left;
};

bool isKnown(Op op) {
    return op >= Op::WarpSample && op <= Op::SceneFacts;
}

constexpr std::size_t kSmallestFile = 8;     ///< two empty strings
constexpr std::size_t kSmallestRequest = 32; ///< everything empty

} // namespace

std::string encode(const RequestGroup &group) {
    Writer writer;
    writer.put(kMagic);
    writer.put(kVersion);
    writer.putSize(group.files.size());
    for (const File &file : group.files) {
        writer.put(file.name);
        writer.put(file.bytes);
    }
    writer.putSize(group.requests.size());
    for (const Request &request : group.requests) {
        writer.put(request.op);
        writer.put(request.text);
        writer.put(request.index);
        writer.put(request.repeats);
        writer.put(request.seed);
        writer.put(request.parameter);
        writer.put(request.values);
    }
    return writer.take();
}

RequestGroup decode(const char *data, std::size_t size) {
    Reader reader(data, size);
    if (reader.get<std::uint32_t>() != kMagic || reader.get<std::uint32_t>() != kVersion)
        throw std::runtime_error("protocol: not a request group of this version");
    RequestGroup group;
    group.files.resize(reader.getCount(kSmallestFile));
    for (File &file : group.files) {
        file.name = reader.getString();
        file.bytes = reader.getString();
    }
    group.requests.resize(reader.getCount(kSmallestRequest));
    for (Request &request : group.requests) {
        request.op = reader.get<Op>();
        if (!isKnown(request.op))
            throw std::runtime_error("protocol: unknown op");
        request.text = reader.getString();
        request.index = reader.get<std::uint32_t>();
        request.repeats = reader.get<std::uint32_t>();
        request.seed = reader.get<std::uint64_t>();
        request.parameter = reader.get<float>();
        request.values = reader.getFloats();
    }
    reader.requireEnd();
    return group;
}

} // namespace protocol
