// SPDX-License-Identifier: MIT
#pragma once

#include <nori/class_names.h>
#include <nori/proplist.h>

#include <functional>
#include <map>

NORI_NAMESPACE_BEGIN

/// Anything that a scene file can name. An object is built from its properties, then given its
/// children, and last activated (see loadFromXML() for the exact order).
class NoriObject {
public:
    enum EClassType {
        EScene = 0,
        EMesh,
        EBSDF,
        ETexture,
        EPhaseFunction,
        EEmitter,
        EMedium,
        ECamera,
        EIntegrator,
        ESampler,
        ETest,
        EReconstructionFilter,
        EClassTypeCount
    };

    virtual ~NoriObject() = default;

    virtual EClassType getClassType() const = 0;

    /// Takes ownership of `child`. `name` is its XML attribute `name`. Throws NoriException unless
    /// overridden.
    virtual void addChild(NoriObject *child, const std::string &name = "none");

    /// Called after `parent` has accepted this object by addChild().
    virtual void setParent(NoriObject *parent);

    /// Called once, after all children were added.
    virtual void activate();

    /// What this object is and holds, for people.
    virtual std::string toString() const = 0;

    static std::string classTypeName(EClassType type) {
        switch (type) {
        case EScene:
            return "scene";
        case EMesh:
            return "mesh";
        case EBSDF:
            return "bsdf";
        case EPhaseFunction:
            return "phase";
        case EEmitter:
            return "emitter";
        case EMedium:
            return "medium";
        case ECamera:
            return "camera";
        case EIntegrator:
            return "integrator";
        case ESampler:
            return "sampler";
        case ETest:
            return "test";
        default:
            return "<unknown>";
        }
    }
};

/// Makes objects from the `type` attribute of their XML element.
class NoriObjectFactory {
public:
    typedef std::function<NoriObject *(const PropertyList &)> Constructor;

    /// A later registration under the same name replaces the earlier one.
    static void registerClass(const std::string &name, const Constructor &constr);

    /// The caller owns the result. Throws NoriException if no class has this name.
    static NoriObject *createInstance(const std::string &name, const PropertyList &propList) {
        if (!m_constructors || m_constructors->find(name) == m_constructors->end())
            throw NoriException("A constructor for class \"%s\" could not be found!", name);
        return (*m_constructors)[name](propList);
    }

private:
    // a pointer: registrars of other files may run before this one's static objects exist
    static std::map<std::string, Constructor> *m_constructors;
};

/// Makes `cls` available to scene files under `name`. Works with and without a trailing semicolon.
/// The file must be linked as an object: an archive member that is not referred to is dropped.
#define NORI_REGISTER_CLASS(cls, name)                                                             \
    nori::NoriObject *cls##_create(const nori::PropertyList &list) {                               \
        return new cls(list);                                                                      \
    }                                                                                              \
    static struct cls##_ {                                                                         \
        cls##_() {                                                                                 \
            nori::NoriObjectFactory::registerClass(name, cls##_create);                            \
            nori::ClassNames::add(nori::classTypeOf<cls, nori::NoriObject>(), name);               \
        }                                                                                          \
    } cls##__NORI_;

NORI_NAMESPACE_END
