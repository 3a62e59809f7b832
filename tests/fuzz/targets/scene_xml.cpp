// SPDX-License-Identifier: MIT
#include <nori/parser.h>

#include <memory>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    static const ScratchFile file;
    try {
        const std::unique_ptr<nori::NoriObject> root(nori::loadFromXML(file.write(bytes)));
        require(root != nullptr, "a scene or an error");
        (void)root->toString();
    } catch (const nori::NoriException &) {
    }
}
