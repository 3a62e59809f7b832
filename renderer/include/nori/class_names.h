// SPDX-License-Identifier: MIT
#pragma once

#include <nori/common.h>

#include <type_traits>

NORI_NAMESPACE_BEGIN

class Texture;

/// Which `type` names exist per kind of object, for error messages ("unknown emitter; known: ...").
/// Not part of Nori: kept beside the factory so that the factory's interface stays Nori's.
/// Kinds are the numbers of NoriObject::EClassType.
class ClassNames {
public:
    /// Called by NORI_REGISTER_CLASS; adding twice is harmless.
    static void add(int classType, const std::string &name);

    /// Sorted names of one kind; empty if there are none.
    static std::vector<std::string> of(int classType);
};

/// The kind that `T` will say it is, found from its base class, so that nothing is constructed.
/// -1 for a class that derives from none of them.
template <typename T, typename ClassType>
constexpr int classTypeOf() {
    struct Kind {
        bool matches;
        int classType;
    };

    // is_base_of allows an incomplete base: a header that T's file does not include is not T's base
    constexpr Kind kinds[] = {
        {std::is_base_of<Emitter, T>::value, ClassType::EEmitter},
        {std::is_base_of<BSDF, T>::value, ClassType::EBSDF},
        {std::is_base_of<Texture, T>::value, ClassType::ETexture},
        {std::is_base_of<Mesh, T>::value, ClassType::EMesh},
        {std::is_base_of<Integrator, T>::value, ClassType::EIntegrator},
        {std::is_base_of<Sampler, T>::value, ClassType::ESampler},
        {std::is_base_of<Camera, T>::value, ClassType::ECamera},
        {std::is_base_of<ReconstructionFilter, T>::value, ClassType::EReconstructionFilter},
        {std::is_base_of<Scene, T>::value, ClassType::EScene}};
    for (const Kind &kind : kinds) {
        if (kind.matches)
            return kind.classType;
    }
    return -1;
}

NORI_NAMESPACE_END
