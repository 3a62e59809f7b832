// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

/// Densities in single precision as students write them: right ones, and wrong twins.
namespace sample_densities {

using battery::Output;

inline constexpr float kPi = 3.14159265358979323846F;
inline constexpr float kInvPi = 1.0F / kPi;

struct SampleDensity {
    std::string_view warpId;
    std::string_view name;
    float (*density)(const Output &p, float a);
    /// What the catalogue should say of a wrong one; empty: nothing.
    std::string_view mistakeId{};
    std::string_view constantName{};
    int cosinePower = 0;
};

inline bool inTriangle(const Output &p) {
    return p.x >= 0.0F && p.y >= 0.0F && p.x + p.y <= 1.0F;
}

/// exp(-t / s) / (pi s z^power)
inline float lobe(float t, float s, float z, int power) {
    return std::exp(-t / s) / (kPi * s * std::pow(z, static_cast<float>(power)));
}

inline const auto kRight = std::to_array<SampleDensity>({
    {"square", "closed",
     [](const Output &p, float) {
         return p.x >= 0.0F && p.y >= 0.0F && p.x <= 1.0F && p.y <= 1.0F ? 1.0F : 0.0F;
     }},
    {"tent", "product",
     [](const Output &p, float) {
         const float x = 1.0F - std::fabs(p.x);
         const float y = 1.0F - std::fabs(p.y);
         return x > 0.0F && y > 0.0F ? x * y : 0.0F;
     }},
    {"disk", "squared_norm",
     [](const Output &p, float) {
         return p.x * p.x + p.y * p.y <= 1.0F ? kInvPi : 0.0F;
     }},
    {"disk", "open",
     [](const Output &p, float) {
         return std::hypot(p.x, p.y) < 1.0F ? kInvPi : 0.0F;
     }},
    {"triangle", "closed",
     [](const Output &p, float) {
         return inTriangle(p) ? 2.0F : 0.0F;
     }},
    {"triangle", "open",
     [](const Output &p, float) {
         return p.x > 0.0F && p.y > 0.0F && p.x < 1.0F - p.y ? 2.0F : 0.0F;
     }},
    {"sphere", "constant",
     [](const Output &, float) {
         return 0.25F * kInvPi;
     }},
    {"hemisphere", "closed",
     [](const Output &p, float) {
         return p.z >= 0.0F ? 0.5F * kInvPi : 0.0F;
     }},
    {"hemisphere", "open",
     [](const Output &p, float) {
         return p.z > 0.0F ? 0.5F * kInvPi : 0.0F;
     }},
    {"cosine_hemisphere", "maximum",
     [](const Output &p, float) {
         return std::fmax(0.0F, p.z) * kInvPi;
     }},
    {"cosine_hemisphere", "cosine_from_sine",
     [](const Output &p, float) {
         return p.z <= 0.0F ? 0.0F
                            : std::sqrt(std::fmax(0.0F, 1.0F - p.x * p.x - p.y * p.y)) * kInvPi;
     }},
    {"beckmann", "tangent_from_xy",
     [](const Output &p, float a) {
         return p.z <= 0.0F ? 0.0F : lobe((p.x * p.x + p.y * p.y) / (p.z * p.z), a * a, p.z, 3);
     }},
    {"beckmann", "tangent_from_z",
     [](const Output &p, float a) {
         return p.z <= 0.0F ? 0.0F : lobe((1.0F - p.z * p.z) / (p.z * p.z), a * a, p.z, 3);
     }},
    {"beckmann", "d_times_cosine",
     [](const Output &p, float a) {
         const float theta = std::acos(p.z);
         const float t = std::tan(theta);
         return p.z <= 0.0F ? 0.0F : lobe(t * t, a * a, p.z, 4) * p.z;
     }},
});

inline const auto kWrong = std::to_array<SampleDensity>({
    {"triangle", "one", [](const Output &p, float) { return inTriangle(p) ? 1.0F : 0.0F; }, "",
     "1/2"},
    {"triangle", "half", [](const Output &p, float) { return inTriangle(p) ? 0.5F : 0.0F; }, "",
     "1/4"},
    {"triangle", "no_lower_bounds",
     [](const Output &p, float) { return p.x + p.y <= 1.0F ? 2.0F : 0.0F; }, "no_lower_bounds"},
    {"triangle", "not_implemented", [](const Output &, float) { return 0.0F; }, "zero"},
    {"disk", "everywhere", [](const Output &, float) { return kInvPi; }, "everywhere"},
    {"disk", "pi_3_14",
     [](const Output &p, float) { return p.x * p.x + p.y * p.y <= 1.0F ? 1.0F / 3.14F : 0.0F; }, "",
     "pi/3.14"},
    {"disk", "one",
     [](const Output &p, float) { return p.x * p.x + p.y * p.y <= 1.0F ? 1.0F : 0.0F; }, "", "pi"},
    {"sphere", "hemisphere", [](const Output &, float) { return 0.5F * kInvPi; }, "", "2"},
    {"sphere", "pi_3_14", [](const Output &, float) { return 0.25F / 3.14F; }, "", "pi/3.14"},
    {"sphere", "exact_norm", // 0 where rounding puts the norm off 1
     [](const Output &p, float) {
         return p.x * p.x + p.y * p.y + p.z * p.z == 1.0F ? 0.25F * kInvPi : 0.0F;
     }},
    {"hemisphere", "exact_norm",
     [](const Output &p, float) {
         return p.z >= 0.0F && p.x * p.x + p.y * p.y + p.z * p.z == 1.0F ? 0.5F * kInvPi : 0.0F;
     }},
    {"cosine_hemisphere", "exact_norm",
     [](const Output &p, float) {
         return p.z >= 0.0F && p.x * p.x + p.y * p.y + p.z * p.z == 1.0F ? p.z * kInvPi : 0.0F;
     }},
    {"hemisphere", "sphere_above",
     [](const Output &p, float) { return p.z >= 0.0F ? 0.25F * kInvPi : 0.0F; }, "", "1/2"},
    {"hemisphere", "below_horizon", [](const Output &, float) { return 0.5F * kInvPi; },
     "below_horizon"},
    {"hemisphere", "cosine", [](const Output &p, float) { return std::fmax(0.0F, p.z) * kInvPi; },
     "cosine", "2", 1},
    {"cosine_hemisphere", "absolute",
     [](const Output &p, float) { return std::fabs(p.z) * kInvPi; }, "absolute_cosine"},
    {"cosine_hemisphere", "around_y",
     [](const Output &p, float) { return p.z > 0.0F ? p.y * kInvPi : 0.0F; }, "around_y"},
    {"cosine_hemisphere", "missing_pi", [](const Output &p, float) { return std::fmax(0.0F, p.z); },
     "", "pi"},
    {"beckmann", "missing_cosine",
     [](const Output &p, float a) {
         return p.z <= 0.0F ? 0.0F : lobe((1.0F - p.z * p.z) / (p.z * p.z), a * a, p.z, 4);
     },
     "missing_cosine", "1", -1},
    {"beckmann", "alpha_not_squared",
     [](const Output &p, float a) {
         return p.z <= 0.0F ? 0.0F : lobe((1.0F - p.z * p.z) / (p.z * p.z), a, p.z, 3);
     },
     "alpha_not_squared"},
    {"beckmann", "alpha_not_squared_in_front",
     [](const Output &p, float a) {
         return p.z <= 0.0F ? 0.0F : a * lobe((1.0F - p.z * p.z) / (p.z * p.z), a * a, p.z, 3);
     },
     "", "alpha"},
});

/// Right at every direction that is rounded well, 0 at a few in ten thousand that a warp gives.
inline const auto kWrongAtRounding = std::to_array<SampleDensity>({
    {"sphere", "norm_at_most_one", // 0 where rounding puts the norm above 1
     [](const Output &p, float) {
         return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) <= 1.0F ? 0.25F * kInvPi : 0.0F;
     }},
});

inline std::vector<float> run(const SampleDensity &sample, std::span<const Output> points,
                              double a) {
    std::vector<float> pdfs;
    pdfs.reserve(points.size());
    for (const Output &point : points) {
        pdfs.push_back(sample.density(point, static_cast<float>(a)));
    }
    return pdfs;
}

} // namespace sample_densities
