#include <nori/Warp.h>
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

Point2f Warp::squareToUniformDisk(const Point2f &sample) {
	float theta = 2.0 * M_PI * sample.x();
	float r = sqrt(1.0 - sample.y());
	return Point2f(r * cosf(theta), r * sinf(theta));
}

float Warp::squareToUniformDiskPdf(const Point2f &p) {
	if (sqrt(pow(p.x(), 2) + pow(p.y(), 2)) > 1.00001)
		return 0;
	return 1 / M_PI;
}

// Ordenar dos números y quedarse con los huecos da baricéntricas uniformes
Point2f Warp::squareToUniformTriangle(const Point2f &sample) {
	float menor = std::min(sample.x(), sample.y());
	float mayor = std::max(sample.x(), sample.y());
	return Point2f(menor, mayor - menor);
}

float Warp::squareToUniformTrianglePdf(const Point2f &p) {
	if (p.x() < 0 || p.y() < 0)
		return 0;
	return (p.x() + p.y() < 1 + 1e-5f) ? 2 : 0;
}

Vector3f Warp::squareToUniformSphere(const Point2f &sample) {
	return sphericalDirection(acos(1 - 2 * sample.y()), 2 * M_PI * sample.x());
}

float Warp::squareToUniformSpherePdf(const Vector3f &v) {
	return 1.0 / (4.0 * M_PI);
}

Vector3f Warp::squareToUniformHemisphere(const Point2f &sample) {
	return sphericalDirection(acos(1 - sample.y()), 2 * M_PI * sample.x());
}

float Warp::squareToUniformHemispherePdf(const Vector3f &v) {
	if (Frame::cosTheta(v) < 0)
		return 0;
	return 1.0 / (2.0 * M_PI);
}

Vector3f Warp::squareToCosineHemisphere(const Point2f &sample) {
	// F(theta) = sin^2(theta)
	return sphericalDirection(asin(sqrt(sample.x())), 2 * M_PI * sample.y());
}

float Warp::squareToCosineHemispherePdf(const Vector3f &v) {
	float c = Frame::cosTheta(v);
	return c < 0 ? 0 : c / M_PI;
}

Vector3f Warp::squareToBeckmann(const Point2f &sample, float alpha) {
	float t2 = -pow(alpha, 2) * log(1 - sample.x());
	float c = 1 / sqrt(1 + t2);
	float s = c * sqrt(t2);
	float phi = 2 * M_PI * sample.y();
	return Vector3f(s * cos(phi), s * sin(phi), c);
}

float Warp::squareToBeckmannPdf(const Vector3f &m, float alpha) {
	if (Frame::cosTheta(m) <= 0)
		return 0;
	double c2 = pow((double) m.z(), 2);
	double s2 = pow((double) m.x(), 2) + pow((double) m.y(), 2);
	double a2 = pow((double) alpha, 2);
	return exp(-s2 / (c2 * a2)) / (M_PI * a2 * c2 * m.z());
}

NORI_NAMESPACE_END
