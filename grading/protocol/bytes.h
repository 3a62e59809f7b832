// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace protocol {

// Both sides run on one machine: its own byte order and float format are the format.

/// Puts a message together.
class ByteWriter {
public:
    template <typename T>
    void put(const T &value) {
        append(&value, sizeof(T));
    }

    void put(const std::string &text) {
        putSize(text.size());
        append(text.data(), text.size());
    }

    /// The count is part of it.
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
        throw std::length_error("protocol: more than 4 GiB in one message");
    }

    void append(const void *data, std::size_t size) {
        if (size > kLargest - m_bytes.size())
            throwTooLarge();
        if (size != 0)
            m_bytes.append(static_cast<const char *>(data), size);
    }

    std::string m_bytes;
};

/// Takes a message apart; believes nothing that it reads.
class ByteReader {
public:
    ByteReader(const char *data, std::size_t size) : m_at(data), m_left(size) {}

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

} // namespace protocol
