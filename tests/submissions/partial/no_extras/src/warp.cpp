#include <nori/warp.h>
#include <nori/vector.h>
#include <nori/frame.h>

NORI_NAMESPACE_BEGIN

// El cuadrado y su pdf venían hechos
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

// Los extras no nos ha dado tiempo
Point2f Warp::squareToUniformDisk(const Point2f &sample) {
    throw NoriException("Warp::squareToUniformDisk() is not yet implemented!");
}

float Warp::squareToUniformDiskPdf(const Point2f &p) {
    throw NoriException("Warp::squareToUniformDiskPdf() is not yet implemented!");
}

// Coordenadas baricéntricas uniformes (PBRT 13.6.5)
Point2f Warp::squareToUniformTriangle(const Point2f &sample) {
    float raiz = sqrt(sample.x());
    return Point2f(1 - raiz, sample.y() * raiz);
}

float Warp::squareToUniformTrianglePdf(const Point2f &p) {
    if (p.x() < 0 || p.y() < 0 || p.x() + p.y() > 1.0f + 1e-6f)
        return 0.0f;
    return 2.0f; // area 1/2
}

Vector3f Warp::squareToUniformSphere(const Point2f &sample) {
    float theta = acos(1 - 2 * sample.x());
    float phi = 2 * M_PI * sample.y();
    return Vector3f(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
}

float Warp::squareToUniformSpherePdf(const Vector3f &v) {
    return INV_FOURPI;
}

Vector3f Warp::squareToUniformHemisphere(const Point2f &sample) {
    float theta = acos(sample.x());
    float phi = 2 * M_PI * sample.y();
    return Vector3f(sin(theta) * cos(phi), sin(theta) * sin(phi), sample.x());
}

float Warp::squareToUniformHemispherePdf(const Vector3f &v) {
    return v.z() < 0 ? 0.0f : INV_TWOPI;
}

Vector3f Warp::squareToCosineHemisphere(const Point2f &sample) {
    float r = sqrt(sample.x());
    float phi = 2 * M_PI * sample.y();
    return Vector3f(r * cos(phi), r * sin(phi), sqrt(1 - sample.x()));
}

float Warp::squareToCosineHemispherePdf(const Vector3f &v) {
    if (v.z() <= 0)
        return 0.0f;
    return v.z() * INV_PI;
}

Vector3f Warp::squareToBeckmann(const Point2f &sample, float alpha) {
    throw NoriException("Warp::squareToBeckmann() is not yet implemented!");
}

float Warp::squareToBeckmannPdf(const Vector3f &m, float alpha) {
    throw NoriException("Warp::squareToBeckmannPdf() is not yet implemented!");
}

NORI_NAMESPACE_END
