// SPDX-License-Identifier: MIT
#include <nori/scene_text.h>

#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

NORI_NAMESPACE_BEGIN

SceneText::SceneText(const std::string &fileName) : m_name(fileName) {
    struct stat status {};

    if (stat(fileName.c_str(), &status) != 0)
        throw NoriException("%s: %s", fileName, std::strerror(errno));
    if (!S_ISREG(status.st_mode))
        throw NoriException("%s: is no file", fileName);
    std::ifstream stream(fileName, std::ios::binary);
    m_bytes.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    if (!stream)
        throw NoriException("%s: cannot be read", fileName);
}

std::string SceneText::place(std::ptrdiff_t offset) const {
    if (offset < 0 || m_bytes.empty())
        return m_name;
    const auto end = std::min(static_cast<size_t>(offset), m_bytes.size());
    const auto line =
        1 + std::count(m_bytes.begin(), m_bytes.begin() + static_cast<long>(end), '\n');
    return m_name + ":" + std::to_string(line);
}

std::string joinNames(const std::vector<std::string> &names) {
    std::string text;
    for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

NORI_NAMESPACE_END
