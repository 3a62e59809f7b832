// SPDX-License-Identifier: MIT
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

#include <decoder/decode.h>

namespace {

// What the grader passes; see decodeImage().
constexpr int kFile = 3;
constexpr int kAnswer = 4;

bool writeAll(const std::string &bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = write(kAnswer, bytes.data() + done, bytes.size() - done);
        if (count <= 0)
            return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

} // namespace

int main() {
    struct stat status {};

    if (fstat(kFile, &status) != 0) {
        std::fputs("decoder: is started by norigrade, with an image as descriptor 3\n", stderr);
        return 2;
    }
    const auto size = static_cast<std::size_t>(status.st_size);
    const void *data = size == 0 ? nullptr : mmap(nullptr, size, PROT_READ, MAP_PRIVATE, kFile, 0);
    if (data == MAP_FAILED)
        return 1;
    try {
        return writeAll(encode(decoder::decode(static_cast<const char *>(data), size))) ? 0 : 1;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "decoder: %s\n", error.what());
        return 1;
    }
}
