// SPDX-License-Identifier: MIT
#pragma once

#if defined(__APPLE__)
#define PLATFORM_MACOS
#elif defined(_WIN32)
#define PLATFORM_WINDOWS
#else
#define PLATFORM_LINUX
#endif

// The C headers put abs(), sqrt(), isnan() ... for float into the global namespace. With <cmath>
// alone, an unqualified abs(0.5f) in a submission would pick int abs(int) and yield 0.
#include <Eigen/Core>
#include <tinyformat.h>

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include <algorithm>
#include <cassert>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#define NORI_NAMESPACE_BEGIN namespace nori {
#define NORI_NAMESPACE_END }

/// Offset of secondary rays, relative to the scale of the scene. A macro, as in Nori: the
/// accelerator recognises rays whose mint is exactly this number.
#define Epsilon 1e-4f

// Float on purpose (libc's are double): the constants take part in std::max() and in ?: of floats.
#undef M_PI
#define M_PI 3.14159265358979323846f
#define INV_PI 0.31830988618379067154f
#define INV_TWOPI 0.15915494309189533577f
#define INV_FOURPI 0.07957747154594766788f
#define SQRT_TWO 1.41421356237309504880f
#define INV_SQRT_TWO 0.70710678118654752440f

namespace filesystem {
class path;
class resolver;
} // namespace filesystem

NORI_NAMESPACE_BEGIN

template <typename Scalar, int Dimension>
struct TVector;
template <typename Scalar, int Dimension>
struct TPoint;
template <typename Point, typename Vector>
struct TRay;
template <typename Point>
struct TBoundingBox;

typedef TVector<float, 1> Vector1f;
typedef TVector<float, 2> Vector2f;
typedef TVector<float, 3> Vector3f;
typedef TVector<float, 4> Vector4f;
typedef TVector<double, 1> Vector1d;
typedef TVector<double, 2> Vector2d;
typedef TVector<double, 3> Vector3d;
typedef TVector<double, 4> Vector4d;
typedef TVector<int, 1> Vector1i;
typedef TVector<int, 2> Vector2i;
typedef TVector<int, 3> Vector3i;
typedef TVector<int, 4> Vector4i;
typedef TPoint<float, 1> Point1f;
typedef TPoint<float, 2> Point2f;
typedef TPoint<float, 3> Point3f;
typedef TPoint<float, 4> Point4f;
typedef TPoint<double, 1> Point1d;
typedef TPoint<double, 2> Point2d;
typedef TPoint<double, 3> Point3d;
typedef TPoint<double, 4> Point4d;
typedef TPoint<int, 1> Point1i;
typedef TPoint<int, 2> Point2i;
typedef TPoint<int, 3> Point3i;
typedef TPoint<int, 4> Point4i;
typedef TBoundingBox<Point1f> BoundingBox1f;
typedef TBoundingBox<Point2f> BoundingBox2f;
typedef TBoundingBox<Point3f> BoundingBox3f;
typedef TBoundingBox<Point4f> BoundingBox4f;
typedef TBoundingBox<Point1d> BoundingBox1d;
typedef TBoundingBox<Point2d> BoundingBox2d;
typedef TBoundingBox<Point3d> BoundingBox3d;
typedef TBoundingBox<Point4d> BoundingBox4d;
typedef TBoundingBox<Point1i> BoundingBox1i;
typedef TBoundingBox<Point2i> BoundingBox2i;
typedef TBoundingBox<Point3i> BoundingBox3i;
typedef TBoundingBox<Point4i> BoundingBox4i;
typedef TRay<Point2f, Vector2f> Ray2f;
typedef TRay<Point3f, Vector3f> Ray3f;
typedef Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic> MatrixXf;
typedef Eigen::Matrix<uint32_t, Eigen::Dynamic, Eigen::Dynamic> MatrixXu;

class BSDF;
class Bitmap;
class BlockGenerator;
class Camera;
class Emitter;
class ImageBlock;
class Integrator;
class KDTree;
class Mesh;
class NoriObject;
class NoriObjectFactory;
class NoriScreen;
class PhaseFunction;
class ReconstructionFilter;
class Sampler;
class Scene;
struct EmitterQueryRecord;

using std::cerr;
using std::cout;
using std::endl;

/// What every failure of the renderer is reported with; the message is formatted as by printf().
class NoriException : public std::runtime_error {
public:
    template <typename... Args>
    NoriException(const char *fmt, const Args &...args)
        : std::runtime_error(tfm::format(fmt, args...)) {}
};

/// Measure that a density or a BSDF value refers to.
enum EMeasure { EUnknownMeasure = 0, ESolidAngle, EDiscrete };

/// Number of processors that this process may use, at least 1.
extern int getCoreCount();

/// Indents every line of `string` but the first.
extern std::string indent(const std::string &string, int amount = 2);

/// ASCII letters in lower case; other bytes (UTF-8) are kept.
extern std::string toLower(const std::string &value);

/// "true" or "false" in any case; else throws NoriException.
extern bool toBool(const std::string &str);

/// Decimal number in the range of its type; NaN or anything after it throws NoriException.
extern int toInt(const std::string &str);
extern unsigned int toUInt(const std::string &str);
extern float toFloat(const std::string &str);

/// Exactly three numbers, separated by commas or blanks; else throws NoriException.
extern Eigen::Vector3f toVector3f(const std::string &str);

/// Cuts `s` at every character that is in `delim`.
extern std::vector<std::string> tokenize(const std::string &s, const std::string &delim = ", ",
                                         bool includeEmpty = false);

extern bool endsWith(const std::string &value, const std::string &ending);

/// Duration given in milliseconds, in the largest unit that suits it ("1.5m").
extern std::string timeString(double time, bool precise = false);

/// Amount of memory given in bytes, in the largest unit that suits it ("1.5 MiB").
extern std::string memString(size_t size, bool precise = false);

inline float radToDeg(float value) {
    return value * (180.0f / M_PI);
}

inline float degToRad(float value) {
    return value * (M_PI / 180.0f);
}

inline float clamp(float value, float min, float max) {
    if (value < min)
        return min;
    return value > max ? max : value;
}

inline int clamp(int value, int min, int max) {
    if (value < min)
        return min;
    return value > max ? max : value;
}

/// (1 - t) v1 + t v2. Mind the order: t comes first.
inline float lerp(float t, float v1, float v2) {
    return (1.0f - t) * v1 + t * v2;
}

/// Remainder of a / b that is never negative (b > 0).
inline int mod(int a, int b) {
    const int r = a % b;
    return r < 0 ? r + b : r;
}

#if !defined(PLATFORM_LINUX)
inline void sincosf(float theta, float *sine, float *cosine) {
    *sine = sinf(theta);
    *cosine = cosf(theta);
}
#endif

/// Unit vector at polar angle `theta` from +z and azimuth `phi` from +x [rad].
extern Vector3f sphericalDirection(float theta, float phi);

/// Inverse of sphericalDirection(): (theta in [0, pi], phi in [0, 2 pi)).
extern Point2f sphericalCoordinates(const Vector3f &dir);

/// Unpolarised Fresnel reflectance of a dielectric boundary, from either side: a negative
/// `cosThetaI` is seen from the inside. \return a fraction in [0, 1], 1 on total reflection.
extern float fresnel(float cosThetaI, float extIOR, float intIOR);

/// Where scene files look for what they name; one per process.
extern filesystem::resolver *getFileResolver();

NORI_NAMESPACE_END
