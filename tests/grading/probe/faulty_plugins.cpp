// SPDX-License-Identifier: MIT
#include <nori/emitter.h>
#include <nori/integrator.h>
#include <nori/sampler.h>

#include <cstdlib>
#include <string>

// What submissions do wrong, so that the probe meets it: linked beside the complete renderer.

NORI_NAMESPACE_BEGIN

namespace {

/// An emitter that makes the mistake that its property `mistake` names, and else answers 1.
class FaultyEmitter : public Emitter {
public:
    FaultyEmitter(const PropertyList &props) : m_mistake(props.getString("mistake")) {
        m_type = EmitterType::EMITTER_POINT;
    }

    Color3f sample(EmitterQueryRecord &, const Point2f &, float) const override {
        if (m_mistake == "sample_exits")
            std::exit(0);
        if (m_mistake == "sample_throws_long_message")
            throw NoriException("%s", std::string(100000, 'm'));
        return {1.0f, 2.0f, 3.0f};
    }

    float pdf(const EmitterQueryRecord &) const override {
        if (m_mistake == "pdf_throws")
            throw NoriException("not yet implemented!");
        return 1.0f;
    }

    Color3f eval(const EmitterQueryRecord &) const override {
        if (m_mistake == "eval_throws_int")
            throw 42; // NOLINT(misc-throw-by-value-catch-by-reference): that is the mistake
        if (m_mistake == "eval_aborts")
            std::abort();
        return {1.0f};
    }

    std::string toString() const override { return "FaultyEmitter[]"; }

private:
    std::string m_mistake;
};

/// Its preprocess() throws.
class FaultyIntegrator : public Integrator {
public:
    FaultyIntegrator(const PropertyList &) {}

    void preprocess(const Scene *) override { throw NoriException("cannot prepare"); }

    Color3f Li(const Scene *, Sampler *, const Ray3f &) const override { return {1.0f}; }

    std::string toString() const override { return "FaultyIntegrator[]"; }
};

/// Tells in its radiance how often it was prepared.
class CountingIntegrator : public Integrator {
public:
    CountingIntegrator(const PropertyList &) {}

    void preprocess(const Scene *) override { m_count += 1.0f; }

    Color3f Li(const Scene *, Sampler *, const Ray3f &) const override { return {m_count}; }

    std::string toString() const override { return "CountingIntegrator[]"; }

private:
    float m_count = 0.0f;
};

/// Three numbers of the sampler, or what a member that all threads share has become of them.
class DrawingIntegrator : public Integrator {
public:
    DrawingIntegrator(const PropertyList &, bool shares = false) : m_shares(shares) {}

    Color3f Li(const Scene *, Sampler *sampler, const Ray3f &) const override {
        Color3f own;
        Color3f &drawn = m_shares ? m_drawn : own;
        for (int i = 0; i < 3; ++i)
            drawn[i] = sampler->next1D();
        return drawn;
    }

    std::string toString() const override { return "DrawingIntegrator[]"; }

private:
    bool m_shares;
    mutable Color3f m_drawn;
};

class SharingIntegrator : public DrawingIntegrator {
public:
    SharingIntegrator(const PropertyList &props) : DrawingIntegrator(props, true) {}
};

} // namespace

NORI_REGISTER_CLASS(DrawingIntegrator, "drawing")
NORI_REGISTER_CLASS(SharingIntegrator, "sharing")
NORI_REGISTER_CLASS(FaultyEmitter, "faulty")
NORI_REGISTER_CLASS(FaultyIntegrator, "faulty_integrator")
NORI_REGISTER_CLASS(CountingIntegrator, "counting")

NORI_NAMESPACE_END
