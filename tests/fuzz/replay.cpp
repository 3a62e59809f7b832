// SPDX-License-Identifier: MIT
//
// Gives a reader the inputs that are kept for it: seeds, and what once broke it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "target.h"

int main(int argc, char **argv) {
    if (argc != 2) {
        std::fputs("usage: replay FOLDER\n", stderr);
        return 2;
    }
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(argv[1]))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path &file : files) {
        std::printf("%s\n", file.filename().c_str());
        std::fflush(stdout); // it may be the last thing we say
        std::ifstream stream(file, std::ios::binary);
        fuzz::run(std::string(std::istreambuf_iterator<char>(stream), {}));
    }
    std::printf("%zu inputs\n", files.size());
    return files.empty() ? 1 : 0;
}
