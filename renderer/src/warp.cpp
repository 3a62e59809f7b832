// SPDX-License-Identifier: MIT
#include <nori/frame.h>
#include <nori/vector.h>
#include <nori/warp.h>

NORI_NAMESPACE_BEGIN

// graded: begin
namespace {

/// Inverse of the cumulative triangle density on [-1, 1].
float tent(float u) {
    return u < 0.5f ? std::sqrt(2.0f * u) - 1.0f
                    : 1.0f - std::sqrt(std::max(0.0f, 2.0f - 2.0f * u));
}

/// The uniform disk: area grows with r^2.
Point2f onDisk(const Point2f &sample) {
    const float r = std::sqrt(sample.x());
    const float phi = 2.0f * M_PI * sample.y();
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// sqrt(1 - x^2), 0 where rounding has taken x beyond 1.
float complement(float x) {
    return std::sqrt(std::max(0.0f, 1.0f - x * x));
}

} // namespace

// graded: end

Point2f Warp::squareToUniformSquare(const Point2f &sample) {
    return sample;
}

float Warp::squareToUniformSquarePdf(const Point2f &p) {
    return ((p.array() >= 0).all() && (p.array() <= 1).all()) ? 1.0f : 0.0f;
}

Point2f Warp::squareToTent(const Point2f &sample) {
    // graded: begin Warp::squareToTent() is not yet implemented!
    return {tent(sample.x()), tent(sample.y())};
    // graded: end
}

float Warp::squareToTentPdf(const Point2f &p) {
    // graded: begin Warp::squareToTentPdf() is not yet implemented!
    return std::max(0.0f, 1.0f - std::abs(p.x())) * std::max(0.0f, 1.0f - std::abs(p.y()));
    // graded: end
}

Point2f Warp::squareToUniformDisk(const Point2f &sample) {
    // graded: begin Warp::squareToUniformDisk() is not yet implemented!
    return onDisk(sample);
    // graded: end
}

float Warp::squareToUniformDiskPdf(const Point2f &p) {
    // graded: begin Warp::squareToUniformDiskPdf() is not yet implemented!
    return p.squaredNorm() <= 1.0f ? INV_PI : 0.0f;
    // graded: end
}

Point2f Warp::squareToUniformTriangle(const Point2f &sample) {
    // graded: begin Warp::squareToUniformTriangle() is not yet implemented!
    const float root = std::sqrt(std::max(0.0f, 1.0f - sample.x())); // PBRT3 13.6.5
    return {1.0f - root, sample.y() * root};
    // graded: end
}

float Warp::squareToUniformTrianglePdf(const Point2f &p) {
    // graded: begin Warp::squareToUniformTrianglePdf() is not yet implemented!
    return p.x() >= 0.0f && p.y() >= 0.0f && p.x() + p.y() <= 1.0f ? 2.0f : 0.0f;
    // graded: end
}

Vector3f Warp::squareToUniformSphere(const Point2f &sample) {
    // graded: begin Warp::squareToUniformSphere() is not yet implemented!
    const float z = 1.0f - 2.0f * sample.x(); // Archimedes: z is uniform
    const float r = complement(z);
    const float phi = 2.0f * M_PI * sample.y();
    return {r * std::cos(phi), r * std::sin(phi), z};
    // graded: end
}

float Warp::squareToUniformSpherePdf(const Vector3f &v) {
    // graded: begin Warp::squareToUniformSpherePdf() is not yet implemented!
    (void)v; // a direction: all of them are in the domain
    return INV_FOURPI;
    // graded: end
}

Vector3f Warp::squareToUniformHemisphere(const Point2f &sample) {
    // graded: begin Warp::squareToUniformHemisphere() is not yet implemented!
    const float z = 1.0f - sample.x();
    const float r = complement(z);
    const float phi = 2.0f * M_PI * sample.y();
    return {r * std::cos(phi), r * std::sin(phi), z};
    // graded: end
}

float Warp::squareToUniformHemispherePdf(const Vector3f &v) {
    // graded: begin Warp::squareToUniformHemispherePdf() is not yet implemented!
    return Frame::cosTheta(v) >= 0.0f ? INV_TWOPI : 0.0f;
    // graded: end
}

Vector3f Warp::squareToCosineHemisphere(const Point2f &sample) {
    // graded: begin Warp::squareToCosineHemisphere() is not yet implemented!
    const Point2f p = onDisk(sample); // Malley: lift a uniform disk (PBRT3 13.6.3)
    return {p.x(), p.y(), std::sqrt(std::max(0.0f, 1.0f - p.squaredNorm()))};
    // graded: end
}

float Warp::squareToCosineHemispherePdf(const Vector3f &v) {
    // graded: begin Warp::squareToCosineHemispherePdf() is not yet implemented!
    return std::max(0.0f, Frame::cosTheta(v)) * INV_PI;
    // graded: end
}

Vector3f Warp::squareToBeckmann(const Point2f &sample, float alpha) {
    // graded: begin Warp::squareToBeckmann() is not yet implemented!
    // tan^2(theta) / alpha^2 is exponentially distributed; 1 - u is never 0
    const float tangent2 = -alpha * alpha * std::log(std::max(1.0f - sample.x(), 1e-30f));
    const float z = 1.0f / std::sqrt(1.0f + tangent2);
    const float r = std::sqrt(tangent2) * z; // not complement(z), which cancels for small alpha
    const float phi = 2.0f * M_PI * sample.y();
    return {r * std::cos(phi), r * std::sin(phi), z};
    // graded: end
}

float Warp::squareToBeckmannPdf(const Vector3f &m, float alpha) {
    // graded: begin Warp::squareToBeckmannPdf() is not yet implemented!
    const float cosTheta = Frame::cosTheta(m);
    if (cosTheta <= 0.0f)
        return 0.0f;
    // from x and y rather than 1 - z^2, which cancels for small alpha
    const float sin2 = m.x() * m.x() + m.y() * m.y();
    const float cos2 = cosTheta * cosTheta;
    const float exponential = std::exp(-sin2 / (cos2 * alpha * alpha));
    // towards the horizon the exponential wins over the power of the cosine, but 0/0 is no number
    return exponential > 0.0f ? exponential * INV_PI / (alpha * alpha * cos2 * cosTheta) : 0.0f;
    // graded: end
}

NORI_NAMESPACE_END
