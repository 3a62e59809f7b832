// SPDX-License-Identifier: MIT
#include <nori/color.h>
#include <nori/common.h>
#include <nori/transform.h>

#include <Eigen/LU>
#include <filesystem/resolver.h>

#include <cctype>
#include <cerrno>
#include <iomanip>
#include <thread>

NORI_NAMESPACE_BEGIN

int getCoreCount() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::string indent(const std::string &string, int amount) {
    std::string result;
    for (const char c : string) {
        result += c;
        if (c == '\n')
            result.append(static_cast<size_t>(std::max(amount, 0)), ' ');
    }
    return result;
}

std::string toLower(const std::string &value) {
    std::string result = value;
    for (char &c : result) {
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    }
    return result;
}

bool toBool(const std::string &str) {
    const std::string value = toLower(str);
    if (value != "true" && value != "false")
        throw NoriException("Could not parse boolean value \"%s\"", str);
    return value == "true";
}

int toInt(const std::string &str) {
    char *end = nullptr;
    errno = 0;
    const long result = strtol(str.c_str(), &end, 10);
    const bool inRange = errno == 0 && result >= std::numeric_limits<int>::min() &&
                         result <= std::numeric_limits<int>::max();
    if (str.empty() || *end != '\0' || !inRange)
        throw NoriException("Could not parse integer value \"%s\"", str);
    return static_cast<int>(result);
}

unsigned int toUInt(const std::string &str) {
    char *end = nullptr;
    errno = 0;
    const unsigned long result = strtoul(str.c_str(), &end, 10);
    const bool inRange = errno == 0 && str.find('-') == std::string::npos &&
                         result <= std::numeric_limits<unsigned int>::max();
    if (str.empty() || *end != '\0' || !inRange)
        throw NoriException("Could not parse integer value \"%s\"", str);
    return static_cast<unsigned int>(result);
}

float toFloat(const std::string &str) {
    char *end = nullptr;
    const float result = strtof(str.c_str(), &end);
    if (str.empty() || *end != '\0')
        throw NoriException("Could not parse floating point value \"%s\"", str);
    if (std::isnan(result))
        throw NoriException("\"%s\" is not a number", str);
    return result;
}

Eigen::Vector3f toVector3f(const std::string &str) {
    const std::vector<std::string> tokens = tokenize(str);
    if (tokens.size() != 3)
        throw NoriException("Expected 3 values, found %d in \"%s\"", tokens.size(), str);
    return {toFloat(tokens[0]), toFloat(tokens[1]), toFloat(tokens[2])};
}

std::vector<std::string> tokenize(const std::string &s, const std::string &delim,
                                  bool includeEmpty) {
    std::vector<std::string> tokens;
    size_t start = 0;
    while (start <= s.size()) {
        const size_t end = std::min(s.find_first_of(delim, start), s.size());
        if (end > start || includeEmpty)
            tokens.push_back(s.substr(start, end - start));
        start = end + 1;
    }
    return tokens;
}

bool endsWith(const std::string &value, const std::string &ending) {
    return value.size() >= ending.size() &&
           value.compare(value.size() - ending.size(), ending.size(), ending) == 0;
}

std::string timeString(double time, bool precise) {
    if (!std::isfinite(time))
        return "inf";

    struct Unit {
        double size; ///< in units of the one before
        const char *suffix;
    };

    const Unit units[] = {{1000, "s"}, {60, "m"}, {60, "h"}, {24, "d"}};
    const char *suffix = "ms";
    for (const Unit &unit : units) {
        if (time <= unit.size)
            break;
        time /= unit.size;
        suffix = unit.suffix;
    }
    return tfm::format("%.*f%s", precise ? 4 : 1, time, suffix);
}

std::string memString(size_t size, bool precise) {
    const char *suffixes[] = {"B", "KiB", "MiB", "GiB", "TiB", "PiB"};
    auto value = static_cast<double>(size);
    const char *suffix = suffixes[0];
    for (size_t i = 1; i < std::size(suffixes) && value > 1024; ++i) {
        value /= 1024;
        suffix = suffixes[i];
    }
    return tfm::format("%.*f %s", precise ? 4 : 1, value, suffix);
}

filesystem::resolver *getFileResolver() {
    static filesystem::resolver resolver;
    return &resolver;
}

bool Color3f::isValid() const {
    return (*this >= 0.0f).all() && (*this <= std::numeric_limits<float>::max()).all();
}

Color3f Color3f::toSRGB() const {
    return unaryExpr([](float value) {
        if (value <= 0.0031308f)
            return 12.92f * value;
        return 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
    });
}

Color3f Color3f::toLinearRGB() const {
    return unaryExpr([](float value) {
        if (value <= 0.04045f)
            return value / 12.92f;
        return std::pow((value + 0.055f) / 1.055f, 2.4f);
    });
}

float Color3f::getLuminance() const {
    return coeff(0) * 0.212671f + coeff(1) * 0.715160f + coeff(2) * 0.072169f;
}

Transform::Transform(const Eigen::Matrix4f &trafo)
    : m_transform(trafo), m_inverse(trafo.inverse()) {}

Transform Transform::operator*(const Transform &t) const {
    return {m_transform * t.m_transform, t.m_inverse * m_inverse};
}

std::string Transform::toString() const {
    std::ostringstream out;
    out << m_transform.format(Eigen::IOFormat(4, 0, ", ", ";\n", "", "", "[", "]"));
    return out.str();
}

Vector3f sphericalDirection(float theta, float phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Point2f sphericalCoordinates(const Vector3f &dir) {
    // rounding can take a component of a unit vector beyond 1
    const float theta = std::acos(clamp(dir.z(), -1.0f, 1.0f));
    const float phi = std::atan2(dir.y(), dir.x());
    return {theta, phi < 0.0f ? phi + 2.0f * M_PI : phi};
}

void coordinateSystem(const Vector3f &a, Vector3f &b, Vector3f &c) {
    // c: a turned by 90 degrees in the coordinate plane in which it is longest
    if (std::abs(a.x()) > std::abs(a.y())) {
        const float length = std::sqrt(a.x() * a.x() + a.z() * a.z());
        c = Vector3f(a.z() / length, 0.0f, -a.x() / length);
    } else {
        const float length = std::sqrt(a.y() * a.y() + a.z() * a.z());
        c = Vector3f(0.0f, a.z() / length, -a.y() / length);
    }
    b = Vector3f(c.y() * a.z() - c.z() * a.y(), c.z() * a.x() - c.x() * a.z(),
                 c.x() * a.y() - c.y() * a.x());
}

float fresnel(float cosThetaI, float extIOR, float intIOR) {
    if (extIOR == intIOR)
        return 0.0f;
    const float etaI = cosThetaI < 0.0f ? intIOR : extIOR;
    const float etaT = cosThetaI < 0.0f ? extIOR : intIOR;
    const float cosI = std::abs(cosThetaI);

    const float sinT2 = (etaI / etaT) * (etaI / etaT) * (1.0f - cosI * cosI);
    if (sinT2 > 1.0f)
        return 1.0f; // total reflection
    const float cosT = std::sqrt(1.0f - sinT2);

    const float rs = (etaI * cosI - etaT * cosT) / (etaI * cosI + etaT * cosT);
    const float rp = (etaT * cosI - etaI * cosT) / (etaT * cosI + etaI * cosT);
    return 0.5f * (rs * rs + rp * rp);
}

NORI_NAMESPACE_END
