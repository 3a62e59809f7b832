// SPDX-License-Identifier: MIT
#include <nori/emitter.h>
#include <nori/integrator.h>
#include <nori/parser.h>
#include <probe/probe.h>

#include <filesystem/resolver.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <fstream>
#include <stdexcept>

namespace probe {

namespace {

constexpr char kFolder[] = "scene";

std::string absolute(const std::string &name) {
    char folder[PATH_MAX];
    if (getcwd(folder, sizeof folder) == nullptr)
        throw std::runtime_error("there is no working folder");
    return std::string(folder) + "/" + name;
}

/// Makes every folder above the last component.
void makeFolders(const std::string &file) {
    for (std::size_t slash = file.find('/', 1); slash != std::string::npos;
         slash = file.find('/', slash + 1)) {
        if (mkdir(file.substr(0, slash).c_str(), 0700) != 0 && errno != EEXIST)
            throw std::runtime_error("cannot make a folder for " + file);
    }
}

} // namespace

SceneStore::SceneStore(const std::vector<protocol::File> &files) : m_root(absolute(kFolder)) {
    for (const protocol::File &file : files) {
        if (file.name.empty() || file.name[0] == '/' || file.name.find("..") != std::string::npos)
            throw std::runtime_error("a file must not be called \"" + file.name + "\"");
        const std::string path = m_root + "/" + file.name;
        makeFolders(path);
        std::ofstream stream(path, std::ios::binary);
        stream.write(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
        stream.close();
        if (!stream)
            throw std::runtime_error("cannot write " + path);
    }
    nori::getFileResolver()->prepend(filesystem::path(m_root));
}

nori::Scene &SceneStore::get(const std::string &name) {
    nori::Scene *&scene = m_scenes[name];
    if (scene == nullptr) {
        const std::string path = m_root + "/" + name;
        // Meshes and maps are looked for beside the scene first, as nori does.
        nori::getFileResolver()->prepend(filesystem::path(path.substr(0, path.rfind('/'))));
        scene = dynamic_cast<nori::Scene *>(nori::loadFromXML(path));
        if (scene == nullptr)
            throw std::runtime_error(name + " holds no scene");
    }
    return *scene;
}

nori::Scene &SceneStore::getPrepared(const std::string &name) {
    nori::Scene &scene = get(name);
    if (m_prepared.count(name) == 0) {
        if (scene.getIntegrator() != nullptr)
            scene.getIntegrator()->preprocess(&scene);
        m_prepared.insert(name);
    }
    return scene;
}

Values answerFacts(const nori::Scene &scene) {
    const std::vector<nori::Emitter *> &lights = scene.getLights();
    const bool delta = !lights.empty() && lights.front()->isDelta();
    return {static_cast<float>(lights.size()), static_cast<float>(scene.getMeshes().size()),
            delta ? 1.0f : 0.0f, scene.getEnvironmentalEmitter() != nullptr ? 1.0f : 0.0f,
            scene.getIntegrator() != nullptr ? 1.0f : 0.0f};
}

} // namespace probe
