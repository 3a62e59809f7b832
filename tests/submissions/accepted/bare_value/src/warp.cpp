#include <nori/warp.h>
#include <nori/vector.h>
#include <nori/frame.h>

NORI_NAMESPACE_BEGIN

Point2f Warp::squareToUniformSquare(const Point2f &sample) {
    return sample;
}

float Warp::squareToUniformSquarePdf(const Point2f &p) {
    return ((p.array() >= 0).all() && (p.array() <= 1).all()) ? 1.0f : 0.0f;
}

Point2f Warp::squareToTent(const Point2f &sample) {
    throw NoriException("Warp::squareToTent() is not yet implemented!");
}

float Warp::squareToTentPdf(const Point2f &p) {
    throw NoriException("Warp::squareToTentPdf() is not yet implemented!");
}

// Mapa concéntrico de Shirley y Chiu: los anillos del cuadrado pasan a anillos del disco
Point2f Warp::squareToUniformDisk(const Point2f &sample) {
    float a = 2.f * sample.x() - 1.f;
    float b = 2.f * sample.y() - 1.f;
    if (a == 0.f && b == 0.f)
        return Point2f(0.f, 0.f); // el centro, que si no sale 0/0

    float r, phi;
    if (std::abs(a) > std::abs(b)) {
        r = a;
        phi = (M_PI / 4.f) * (b / a);
    } else {
        r = b;
        phi = M_PI / 2.f - (M_PI / 4.f) * (a / b);
    }
    return Point2f(r * std::cos(phi), r * std::sin(phi));
}

float Warp::squareToUniformDiskPdf(const Point2f &p) {
    return p.norm() <= 1.f + Epsilon ? 1.f / M_PI : 0.f;
}

// Plegamos el cuadrado por la diagonal
Point2f Warp::squareToUniformTriangle(const Point2f &sample) {
    if (sample.x() + sample.y() > 1.f)
        return Point2f(1.f - sample.x(), 1.f - sample.y());
    return sample;
}

float Warp::squareToUniformTrianglePdf(const Point2f &p) {
    bool dentro = p.x() >= 0.f && p.y() >= 0.f && p.x() + p.y() <= 1.f;
    return dentro ? 2.f : 0.f;
}

Vector3f Warp::squareToUniformSphere(const Point2f &sample) {
    // z uniforme en [-1,1] (Arquímedes)
    float z = 2.f * sample.y() - 1.f;
    float r = std::sqrt(std::max(0.f, 1.f - z * z));
    float phi = 2.f * M_PI * sample.x();
    return Vector3f(r * std::cos(phi), r * std::sin(phi), z);
}

float Warp::squareToUniformSpherePdf(const Vector3f &v) {
    return 1.f / (4.f * M_PI);
}

// La esfera con la mitad de abajo reflejada arriba
Vector3f Warp::squareToUniformHemisphere(const Point2f &sample) {
    Vector3f v = squareToUniformSphere(sample);
    v.z() = std::abs(v.z());
    return v;
}

float Warp::squareToUniformHemispherePdf(const Vector3f &v) {
    return v.z() >= 0.f ? 1.f / (2.f * M_PI) : 0.f;
}

Vector3f Warp::squareToCosineHemisphere(const Point2f &sample) {
    Point2f d = squareToUniformDisk(sample);
    return Vector3f(d.x(), d.y(), std::sqrt(std::max(0.f, 1.f - d.squaredNorm())));
}

float Warp::squareToCosineHemispherePdf(const Vector3f &v) {
    return std::max(0.f, v.z()) / M_PI;
}

Vector3f Warp::squareToBeckmann(const Point2f &sample, float alpha) {
    float logaritmo = std::log(1.f - sample.x());
    float theta = std::atan(std::sqrt(-alpha * alpha * logaritmo));
    float phi = 2.f * M_PI * sample.y();
    return sphericalDirection(theta, phi);
}

float Warp::squareToBeckmannPdf(const Vector3f &m, float alpha) {
    if (m.z() <= 0.f)
        return 0.f;
    // en double, que con alpha = 0.05 el float se queda corto
    double c2 = double(m.z()) * m.z();
    double a2 = double(alpha) * alpha;
    double tan2 = (double(m.x()) * m.x() + double(m.y()) * m.y()) / c2;
    return float(std::exp(-tan2 / a2) / (M_PI * a2 * c2 * m.z()));
}

NORI_NAMESPACE_END
