// SPDX-License-Identifier: MIT
#include <nori/proplist.h>

NORI_NAMESPACE_BEGIN

namespace {

/// The XML tags, in the order of PropertyList::Property.
const char *const kTypeNames[] = {"boolean", "integer", "float",  "string",
                                  "color",   "point",   "vector", "transform"};

} // namespace

template <typename T>
void PropertyList::set(const std::string &name, const T &value) {
    if (m_properties.find(name) != m_properties.end())
        cerr << "Property \"" << name << "\" was specified multiple times!" << endl;
    m_properties[name] = value;
}

template <typename T>
const T *PropertyList::find(const std::string &name) const {
    m_queried.insert(name);
    const auto it = m_properties.find(name);
    if (it == m_properties.end())
        return nullptr;
    const T *value = std::get_if<T>(&it->second);
    if (value != nullptr)
        return value;
    throw NoriException("Property '%s' has the wrong type! (expected <%s>, detected <%s>)", name,
                        kTypeNames[Property(T()).index()], kTypeNames[it->second.index()]);
}

template <typename T>
const T &PropertyList::get(const std::string &name) const {
    if (const T *value = find<T>(name))
        return *value;
    throw NoriException("Property '%s' is missing!", name);
}

// Nori's interface has one family of functions per type; they differ in nothing else.
#define NORI_DEFINE_PROPERTY(Type, Name)                                                           \
    void PropertyList::set##Name(const std::string &name, const Type &value) {                     \
        set(name, value);                                                                          \
    }                                                                                              \
    Type PropertyList::get##Name(const std::string &name) const {                                  \
        return get<Type>(name);                                                                    \
    }                                                                                              \
    Type PropertyList::get##Name(const std::string &name, const Type &defaultValue) const {        \
        const auto *value = find<Type>(name);                                                      \
        return value != nullptr ? *value : defaultValue;                                           \
    }

NORI_DEFINE_PROPERTY(bool, Boolean)
NORI_DEFINE_PROPERTY(int, Integer)
NORI_DEFINE_PROPERTY(float, Float)
NORI_DEFINE_PROPERTY(std::string, String)
NORI_DEFINE_PROPERTY(Color3f, Color)
NORI_DEFINE_PROPERTY(Point3f, Point)
NORI_DEFINE_PROPERTY(Vector3f, Vector)
NORI_DEFINE_PROPERTY(Transform, Transform)

#undef NORI_DEFINE_PROPERTY

std::vector<std::string> PropertyList::unqueried() const {
    std::vector<std::string> names;
    for (const auto &property : m_properties) {
        if (m_queried.count(property.first) == 0)
            names.push_back(property.first);
    }
    return names;
}

std::vector<std::string> PropertyList::queried() const {
    return {m_queried.begin(), m_queried.end()};
}

NORI_NAMESPACE_END
