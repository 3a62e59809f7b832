// SPDX-License-Identifier: MIT
#pragma once

#include <nori/color.h>
#include <nori/transform.h>

#include <map>
#include <set>
#include <variant>

NORI_NAMESPACE_BEGIN

/// Named and typed values with which an object is constructed.
///
/// get*(name) throws NoriException if there is no such property; get*(name, defaultValue) does not.
/// Both throw if it has another type: an `<integer>` does not satisfy getFloat().
class PropertyList {
public:
    PropertyList() = default;

    void setBoolean(const std::string &name, const bool &value);
    bool getBoolean(const std::string &name) const;
    bool getBoolean(const std::string &name, const bool &defaultValue) const;

    void setInteger(const std::string &name, const int &value);
    int getInteger(const std::string &name) const;
    int getInteger(const std::string &name, const int &defaultValue) const;

    void setFloat(const std::string &name, const float &value);
    float getFloat(const std::string &name) const;
    float getFloat(const std::string &name, const float &defaultValue) const;

    void setString(const std::string &name, const std::string &value);
    std::string getString(const std::string &name) const;
    std::string getString(const std::string &name, const std::string &defaultValue) const;

    void setColor(const std::string &name, const Color3f &value);
    Color3f getColor(const std::string &name) const;
    Color3f getColor(const std::string &name, const Color3f &defaultValue) const;

    void setPoint(const std::string &name, const Point3f &value);
    Point3f getPoint(const std::string &name) const;
    Point3f getPoint(const std::string &name, const Point3f &defaultValue) const;

    void setVector(const std::string &name, const Vector3f &value);
    Vector3f getVector(const std::string &name) const;
    Vector3f getVector(const std::string &name, const Vector3f &defaultValue) const;

    void setTransform(const std::string &name, const Transform &value);
    Transform getTransform(const std::string &name) const;
    Transform getTransform(const std::string &name, const Transform &defaultValue) const;

    /// Names that are set but that no get*() has asked for so far, sorted: misspelt or meaningless.
    std::vector<std::string> unqueried() const;

    /// Every name that a get*() has asked for so far, set or not, sorted: what the object knows.
    std::vector<std::string> queried() const;

private:
    typedef std::variant<bool, int, float, std::string, Color3f, Point3f, Vector3f, Transform>
        Property;

    template <typename T>
    void set(const std::string &name, const T &value);
    template <typename T>
    const T *find(const std::string &name) const;
    template <typename T>
    const T &get(const std::string &name) const;

    std::map<std::string, Property> m_properties;
    // bookkeeping for unqueried(); a list is read by one thread, the one that parses
    mutable std::set<std::string> m_queried;
};

NORI_NAMESPACE_END
