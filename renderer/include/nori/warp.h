// SPDX-License-Identifier: MIT
#pragma once

#include <nori/sampler.h>

NORI_NAMESPACE_BEGIN

/// Maps of uniform points of [0, 1)^2 to other domains, each with the density of its images.
/// Every density is 0 outside its domain.
class Warp {
public:
    /// [0, 1]^2, density 1.
    static Point2f squareToUniformSquare(const Point2f &sample);
    static float squareToUniformSquarePdf(const Point2f &p);

    /// [-1, 1]^2, density (1 - |x|) (1 - |y|).
    static Point2f squareToTent(const Point2f &sample);
    static float squareToTentPdf(const Point2f &p);

    /// Disk of radius 1 around the origin, density 1/pi.
    static Point2f squareToUniformDisk(const Point2f &sample);
    static float squareToUniformDiskPdf(const Point2f &p);

    /// Triangle (0, 0), (1, 0), (0, 1), density 2. The image is a pair of barycentric coordinates.
    static Point2f squareToUniformTriangle(const Point2f &sample);
    static float squareToUniformTrianglePdf(const Point2f &p);

    /// Unit sphere, density 1/(4 pi) [1/sr].
    static Vector3f squareToUniformSphere(const Point2f &sample);
    static float squareToUniformSpherePdf(const Vector3f &v);

    /// Unit hemisphere around +z, density 1/(2 pi) [1/sr].
    static Vector3f squareToUniformHemisphere(const Point2f &sample);
    static float squareToUniformHemispherePdf(const Vector3f &v);

    /// Unit hemisphere around +z, density cos(theta)/pi [1/sr].
    static Vector3f squareToCosineHemisphere(const Point2f &sample);
    static float squareToCosineHemispherePdf(const Vector3f &v);

    /// Microfacet normals around +z, density D(m) cos(theta) [1/sr] with Beckmann's distribution D
    /// of roughness `alpha` > 0.
    static Vector3f squareToBeckmann(const Point2f &sample, float alpha);
    static float squareToBeckmannPdf(const Vector3f &m, float alpha);
};

NORI_NAMESPACE_END
