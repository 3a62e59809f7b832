// SPDX-License-Identifier: MIT
#pragma once

#include <nori/emitter.h>
#include <nori/scene.h>

NORI_NAMESPACE_BEGIN

/// What a ray meets, and the light that comes along it without any bounce.
struct DirectLight {
    bool isHit = false;               ///< false: `its` is not set
    Intersection its;                 ///< nearest surface
    const Emitter *emitter = nullptr; ///< the area light or environment; null: there is none
    EmitterQueryRecord lRec;          ///< of `emitter`
    Color3f radiance{0.0f};

    DirectLight(const Scene &scene, const Ray3f &ray) {
        isHit = scene.rayIntersect(ray, its);
        if (isHit) {
            if (!its.mesh->isEmitter())
                return;
            emitter = its.mesh->getEmitter();
            lRec = EmitterQueryRecord(emitter, ray.o, its.p, its.shFrame.n, its.uv);
        } else {
            emitter = scene.getEnvironmentalEmitter();
            if (emitter == nullptr)
                return;
            lRec = EmitterQueryRecord(emitter, ray.o, ray.o + ray.d, -ray.d, Point2f(0.0f));
        }
        radiance = emitter->eval(lRec);
    }
};

NORI_NAMESPACE_END
