// SPDX-License-Identifier: MIT
#include <protocol/bytes.h>
#include <protocol/request.h>

namespace protocol {

namespace {

constexpr std::uint32_t kMagic = 0x6e6f7269; // "nori"
constexpr std::uint32_t kVersion = 1;

bool isKnown(Op op) {
    return op >= Op::WarpSample && op <= Op::Film;
}

constexpr std::size_t kSmallestFile = 8;     ///< two empty strings
constexpr std::size_t kSmallestRequest = 32; ///< everything empty

} // namespace

std::string encode(const RequestGroup &group) {
    ByteWriter writer;
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
    ByteReader reader(data, size);
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
