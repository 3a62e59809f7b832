// SPDX-License-Identifier: MIT
#pragma once

#include <nori/camera.h>
#include <nori/parser.h>
#include <nori/scene.h>

#include <filesystem/resolver.h>

#include <fstream>
#include <memory>
#include <string>

#include "fixtures.h"

namespace nori::test {

/// A folder for scene files, where the resolver looks first.
class SceneFolder {
public:
    SceneFolder() { getFileResolver()->prepend(::filesystem::path(m_folder.file(""))); }

    std::string write(const std::string &name, const std::string &text) const {
        std::ofstream(m_folder.file(name), std::ios::binary) << text;
        return m_folder.file(name);
    }

    /// Reads `text` as `scene.xml`. \throws NoriException
    std::unique_ptr<NoriObject> load(const std::string &text) const {
        return std::unique_ptr<NoriObject>(loadFromXML(write("scene.xml", text)));
    }

    /// What load() throws, without the folder's name; empty if it does not.
    std::string errorOf(const std::string &text) const {
        try {
            load(text);
        } catch (const NoriException &error) {
            std::string message = error.what();
            const std::string folder = m_folder.file("");
            for (size_t at = 0; (at = message.find(folder)) != std::string::npos;)
                message.erase(at, folder.size());
            return message;
        }
        return "";
    }

private:
    TemporaryFolder m_folder;
};

/// A scene around some elements, which begin on line 3.
inline std::string sceneWith(const std::string &elements) {
    return "<scene><integrator type=\"direct_ems\"/>\n"
           "<camera type=\"perspective\"><integer name=\"width\" value=\"8\"/></camera>\n" +
           elements + "\n</scene>\n";
}

/// A mesh element for a file.
inline std::string meshOf(const std::string &file) {
    return R"(<mesh type="obj"><string name="filename" value=")" + file + R"("/></mesh>)";
}

} // namespace nori::test
