// SPDX-License-Identifier: MIT
#include <nori/object.h>

#include <set>

NORI_NAMESPACE_BEGIN

void NoriObject::addChild(NoriObject *, const std::string &) {
    throw NoriException("NoriObject::addChild() is not implemented for objects of type '%s'!",
                        classTypeName(getClassType()));
}

void NoriObject::setParent(NoriObject *) {}

void NoriObject::activate() {}

std::map<std::string, NoriObjectFactory::Constructor> *NoriObjectFactory::m_constructors = nullptr;

void NoriObjectFactory::registerClass(const std::string &name, const Constructor &constr) {
    // never freed: other static objects may still ask for it while the program ends
    if (m_constructors == nullptr)
        m_constructors = new std::map<std::string, Constructor>();
    (*m_constructors)[name] = constr;
}

namespace {

std::map<int, std::set<std::string>> &namesByType() {
    static std::map<int, std::set<std::string>> names;
    return names;
}

} // namespace

void ClassNames::add(int classType, const std::string &name) {
    namesByType()[classType].insert(name);
}

std::vector<std::string> ClassNames::of(int classType) {
    const std::set<std::string> &names = namesByType()[classType];
    return {names.begin(), names.end()};
}

NORI_NAMESPACE_END
