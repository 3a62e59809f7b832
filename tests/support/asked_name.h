// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/request.h>

#include <sys/stat.h>
#include <unistd.h>

#include <exception>
#include <string>

namespace test {

/// What a program of many modes is asked to be: its first argument or, if it is started as a probe,
/// the name of the first file of its questions. Empty if nobody says.
inline std::string askedName(int argc, char **argv) {
    constexpr int kQuestions = 3;
    if (argc > 1)
        return argv[1];

    struct stat status {};

    if (::fstat(kQuestions, &status) != 0)
        return {};
    std::string questions(static_cast<std::size_t>(status.st_size), '\0');
    if (::pread(kQuestions, questions.data(), questions.size(), 0) != status.st_size)
        return {};
    try {
        const protocol::RequestGroup group = protocol::decode(questions.data(), questions.size());
        return group.files.empty() ? std::string() : group.files.front().name;
    } catch (const std::exception &) {
        return {};
    }
}

} // namespace test
