// SPDX-License-Identifier: MIT
#include "gnuplot.h"

#include <fmt/core.h>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>

#include "plot.h"

namespace plot {

std::string quoted(const std::string &text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'')
            result += "''";
        else
            result += c == '\n' || c == '\r' ? ' ' : c;
    }
    return result + "'";
}

void writeFile(const std::filesystem::path &file, const std::string &text) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.close();
    if (!stream)
        throw PlotError(fmt::format("{}: cannot be written", file.string()));
}

std::string readFile(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void runGnuplot(const std::filesystem::path &folder, const std::string &commands,
                const std::string &script) {
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0)
        throw PlotError("too many files are open");
    const pid_t process = ::fork();
    if (process < 0)
        throw PlotError("gnuplot cannot be started: too many processes");
    if (process == 0) {
        ::dup2(pipe[1], STDERR_FILENO);
        ::dup2(pipe[1], STDOUT_FILENO);
        ::close(pipe[0]);
        ::close(pipe[1]);
        if (::chdir(folder.c_str()) == 0)
            ::execlp("gnuplot", "gnuplot", "--default-settings", "-e", commands.c_str(),
                     script.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(pipe[1]);
    std::string log;
    std::array<char, 4096> block{};
    for (ssize_t count = 1; count != 0;) {
        count = ::read(pipe[0], block.data(), block.size());
        if (count > 0)
            log.append(block.data(), static_cast<std::size_t>(count));
        else if (count < 0 && errno != EINTR)
            break;
    }
    ::close(pipe[0]);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        throw PlotError("gnuplot cannot be run: install the package gnuplot-nox");
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw PlotError("gnuplot failed: " + log);
}

std::string withTextColour(std::string svg) {
    for (const std::string black : {"\"black\"", "'black'", "\"rgb(  0,   0,   0)\"",
                                    "'rgb(  0,   0,   0)'", "\"rgb(0,0,0)\"", "'rgb(0,0,0)'"}) {
        for (std::size_t at = 0; (at = svg.find(black, at)) != std::string::npos;)
            svg.replace(at, black.size(), "\"currentColor\"");
    }
    return svg;
}

} // namespace plot
