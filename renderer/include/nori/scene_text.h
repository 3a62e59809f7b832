// SPDX-License-Identifier: MIT
#pragma once

#include <nori/common.h>

NORI_NAMESPACE_BEGIN

/// A text file in memory as UTF-8 without a mark, that knows its lines, for error messages.
class SceneText {
public:
    /// Reads UTF-8, or what the XML declaration or a mark of UTF-16 says.
    /// Throws NoriException if the file cannot be read.
    explicit SceneText(const std::string &fileName);

    const std::string &name() const { return m_name; }

    const std::string &bytes() const { return m_bytes; }

    /// `file:line` of a byte offset; a negative one is the whole file.
    std::string place(std::ptrdiff_t offset) const;

private:
    std::string m_name;
    std::string m_bytes;
};

/// `area, environment`; `none` if there are none.
std::string joinNames(const std::vector<std::string> &names);

NORI_NAMESPACE_END
