// SPDX-License-Identifier: MIT
#include "memory_file.h"

#include <grader/error.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace grader {

Descriptor makeMemoryFile(const char *name, std::string_view bytes) {
    Descriptor file(::memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!file)
        throw GraderError("no shared memory can be made: too many files are open");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = ::pwrite(file.get(), bytes.data() + done, bytes.size() - done,
                                       static_cast<off_t>(done));
        if (count <= 0)
            throw GraderError("the shared memory cannot be written: is the machine out of memory?");
        done += static_cast<std::size_t>(count);
    }
    return file;
}

void sealMemoryFile(const Descriptor &file, int seals) {
    if (::fcntl(file.get(), F_ADD_SEALS, seals | F_SEAL_SEAL) != 0)
        throw GraderError("the shared memory cannot be sealed");
}

std::string readMemoryFile(const Descriptor &file, std::size_t size) {
    std::string copy(size, '\0');
    for (std::size_t done = 0; done < size;) {
        const ssize_t count =
            ::pread(file.get(), copy.data() + done, size - done, static_cast<off_t>(done));
        if (count <= 0)
            throw GraderError("the shared memory cannot be read");
        done += static_cast<std::size_t>(count);
    }
    return copy;
}

} // namespace grader
