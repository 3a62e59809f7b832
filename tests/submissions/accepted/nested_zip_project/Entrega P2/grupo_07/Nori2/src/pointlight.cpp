#include <nori/emitter.h>

NORI_NAMESPACE_BEGIN

class PointEmitter : public Emitter {
public:
	PointEmitter(const PropertyList &props) {
		m_type = EmitterType::EMITTER_POINT;
		m_position = props.getPoint("position", Point3f(0.f, 100.f, 0.f));
		m_radiance = props.getColor("radiance", Color3f(1.f));
	}

	virtual std::string toString() const {
		return tfm::format(
			"PointEmitter[\n"
			"  position = %s,\n"
			"  radiance = %s,\n"
			"]",
			m_position.toString(), m_radiance.toString());
	}

	virtual Color3f eval(const EmitterQueryRecord &lRec) const {
		return Color3f(0.f);
	}

	virtual Color3f sample(EmitterQueryRecord &lRec, const Point2f &sample, float optional_u) const {
		lRec.p = m_position;
		lRec.wi = m_position - lRec.ref;
		lRec.dist = lRec.wi.norm();
		lRec.wi /= lRec.dist;
		lRec.n = -lRec.wi;
		lRec.uv = Point2f(0.f);
		lRec.pdf = 1.f;
		return m_radiance / (lRec.dist * lRec.dist);
	}

	virtual float pdf(const EmitterQueryRecord &lRec) const {
		return 1.f;
	}

	virtual float brillo() const {
		return m_radiance.maxCoeff();
	}

protected:
	Point3f m_position;
	Color3f m_radiance;
};

NORI_REGISTER_CLASS(PointEmitter, "pointlight")
NORI_NAMESPACE_END
