// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

/// Warps in single precision as students write them: right ones of every kind, and wrong twins.
namespace sample_warps {

using battery::Input;
using battery::Output;

inline constexpr float kPi = 3.14159265358979323846F;

struct SampleWarp {
    std::string_view warpId;
    std::string_view name;
    Output (*warp)(const Input &s, float a);
    /// The mistake that the catalogue should name for a wrong one; empty: none (too subtle).
    std::string_view mistakeId{};
};

inline Output polar(float r, float angle, float z) {
    return {r * std::cos(angle), r * std::sin(angle), z};
}

inline Output atAngle(float theta, float phi) {
    return polar(std::sin(theta), phi, std::cos(theta));
}

inline Output atHeight(float z, float phi) {
    return polar(std::sqrt(std::max(0.0F, 1.0F - z * z)), phi, z);
}

inline Output ofTangent(float tangent2, float phi) {
    const float z = 1.0F / std::sqrt(1.0F + tangent2);
    return polar(std::sqrt(tangent2) * z, phi, z);
}

/// P. Shirley and K. Chiu, "A low distortion map between disk and square", 1997.
inline Output concentric(const Input &s) {
    const float x = 2.0F * s.u - 1.0F;
    const float y = 2.0F * s.v - 1.0F;
    if (x == 0.0F && y == 0.0F) {
        return {};
    }
    if (std::fabs(x) > std::fabs(y)) {
        return polar(x, kPi / 4.0F * (y / x), 0.0F);
    }
    return polar(y, kPi / 2.0F - kPi / 4.0F * (x / y), 0.0F);
}

inline Output lifted(const Output &d) {
    return {d.x, d.y, std::sqrt(std::max(0.0F, 1.0F - d.x * d.x - d.y * d.y))};
}

/// A third number, uniform for uniform samples.
inline float hash(const Input &s) {
    const float x = 4801.7F * s.u + 9173.3F * s.v;
    return x - std::floor(x);
}

inline float tentQuantile(float p) {
    return p < 0.5F ? std::sqrt(2.0F * p) - 1.0F : 1.0F - std::sqrt(2.0F - 2.0F * p);
}

inline const auto kRight = std::to_array<SampleWarp>({
    {"square", "identity",
     [](const Input &s, float) {
         return Output{s.u, s.v, 0.0F};
     }},
    {"tent", "quantile",
     [](const Input &s, float) {
         return Output{tentQuantile(s.u), tentQuantile(s.v), 0.0F};
     }},
    {"disk", "polar",
     [](const Input &s, float) {
         return polar(std::sqrt(s.u), 2.0F * kPi * s.v, 0.0F);
     }},
    {"disk", "polar_swapped",
     [](const Input &s, float) {
         return polar(std::sqrt(1.0F - s.v), 2.0F * kPi * s.u, 0.0F);
     }},
    {"disk", "concentric",
     [](const Input &s, float) {
         return concentric(s);
     }},
    {"disk", "double_precision",
     [](const Input &s, float) {
         const double r = std::sqrt(1.0 - static_cast<double>(s.u));
         const double phi = 2.0 * std::numbers::pi * static_cast<double>(s.v);
         return Output{static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)),
                       0.0F};
     }},
    {"triangle", "square_root",
     [](const Input &s, float) {
         const float root = std::sqrt(s.u);
         return Output{1.0F - root, s.v * root, 0.0F};
     }},
    {"triangle", "fold",
     [](const Input &s, float) {
         return s.u + s.v > 1.0F ? Output{1.0F - s.u, 1.0F - s.v, 0.0F} : Output{s.u, s.v, 0.0F};
     }},
    {"triangle", "swapped_fold",
     [](const Input &s, float) {
         return s.u + s.v > 1.0F ? Output{1.0F - s.v, 1.0F - s.u, 0.0F} : Output{s.u, s.v, 0.0F};
     }},
    {"triangle", "sorted",
     [](const Input &s, float) {
         return Output{std::min(s.u, s.v), std::max(s.u, s.v) - std::min(s.u, s.v), 0.0F};
     }},
    {"triangle", "square_root_of_rest_swapped",
     [](const Input &s, float) {
         const float root = std::sqrt(1.0F - s.v);
         return Output{root * (1.0F - s.u), 1.0F - root, 0.0F};
     }},
    {"sphere", "height",
     [](const Input &s, float) {
         return atHeight(1.0F - 2.0F * s.u, 2.0F * kPi * s.v);
     }},
    {"sphere", "arc_cosine",
     [](const Input &s, float) {
         return atAngle(std::acos(2.0F * s.u - 1.0F), 2.0F * kPi * s.v);
     }},
    {"sphere", "height_swapped",
     [](const Input &s, float) {
         return atHeight(2.0F * s.v - 1.0F, 2.0F * kPi * s.u);
     }},
    {"hemisphere", "height",
     [](const Input &s, float) {
         return atHeight(s.u, 2.0F * kPi * s.v);
     }},
    {"hemisphere", "reflected_sphere",
     [](const Input &s, float) {
         return atHeight(std::fabs(1.0F - 2.0F * s.u), 2.0F * kPi * s.v);
     }},
    {"hemisphere", "arc_cosine_of_rest",
     [](const Input &s, float) {
         return atAngle(std::acos(1.0F - s.v), 2.0F * kPi * s.u);
     }},
    {"cosine_hemisphere", "malley_concentric",
     [](const Input &s, float) {
         return lifted(concentric(s));
     }},
    {"cosine_hemisphere", "arc_sine",
     [](const Input &s, float) {
         return atAngle(std::asin(std::sqrt(s.u)), 2.0F * kPi * s.v);
     }},
    {"cosine_hemisphere", "arc_cosine",
     [](const Input &s, float) {
         return atAngle(std::acos(std::sqrt(s.u)), 2.0F * kPi * s.v);
     }},
    {"cosine_hemisphere", "normal_plus_sphere",
     [](const Input &s, float) {
         Output d = atHeight(1.0F - 2.0F * s.u, 2.0F * kPi * s.v);
         d.z += 1.0F;
         const float n = std::max(1e-6F, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
         return Output{d.x / n, d.y / n, d.z / n};
     }},
    {"beckmann", "tangent",
     [](const Input &s, float a) {
         return ofTangent(-a * a * std::log(1.0F - s.u), 2.0F * kPi * s.v);
     }},
    {"beckmann", "arc_tangent_of_log_u",
     [](const Input &s, float a) {
         return atAngle(std::atan(std::sqrt(-a * a * std::log(s.u))), 2.0F * kPi * s.v);
     }},
    {"beckmann", "double_precision_swapped",
     [](const Input &s, float a) {
         const auto alpha = static_cast<double>(a);
         const double t = -alpha * alpha * std::log1p(-static_cast<double>(s.v));
         const double z = 1.0 / std::sqrt(1.0 + t);
         const double phi = 2.0 * std::numbers::pi * static_cast<double>(s.u);
         return Output{static_cast<float>(std::sqrt(t) * z * std::cos(phi)),
                       static_cast<float>(std::sqrt(t) * z * std::sin(phi)), static_cast<float>(z)};
     }},
    {"beckmann", "sine_from_cosine", // right, but imprecise at small a
     [](const Input &s, float a) {
         return atHeight(1.0F / std::sqrt(1.0F - a * a * std::log(1.0F - s.v)), 2.0F * kPi * s.u);
     }},
});

inline const auto kWrong = std::to_array<SampleWarp>({
    {"triangle", "missing_root",
     [](const Input &s, float) {
         return Output{1.0F - s.u, s.v * s.u, 0.0F};
     },
     "missing_sqrt"},
    {"triangle", "missing_root_other_corner",
     [](const Input &s, float) {
         return Output{s.u * s.v, s.u * (1.0F - s.v), 0.0F};
     },
     "missing_sqrt"},
    {"triangle", "unfolded",
     [](const Input &s, float) {
         return Output{s.u, s.v, 0.0F};
     },
     "unfolded_square"},
    {"triangle", "clamped",
     [](const Input &s, float) {
         return Output{s.u, std::min(s.v, 1.0F - s.u), 0.0F};
     },
     "clamped"},
    {"triangle", "tilt_half_percent",
     [](const Input &s, float) {
         const float root = std::pow(s.u, 0.4975F);
         return Output{1.0F - root, s.v * root, 0.0F};
     }},
    {"triangle", "normalised_three", // of three random numbers, the third hidden
     [](const Input &s, float) {
         const float third = hash(s);
         const float sum = std::max(1e-6F, s.u + s.v + third);
         return Output{s.u / sum, s.v / sum, 0.0F};
     },
     "three_uniforms"},
    {"disk", "degrees", // 360 v used as radians: 57.3 turns
     [](const Input &s, float) {
         return polar(std::sqrt(s.u), 360.0F * s.v, 0.0F);
     }},
    {"disk", "missing_root",
     [](const Input &s, float) { return polar(s.u, 2.0F * kPi * s.v, 0.0F); }, "missing_sqrt"},
    {"disk", "half_turn",
     [](const Input &s, float) { return polar(std::sqrt(s.v), kPi * s.u, 0.0F); }, "half_turn"},
    {"disk", "pi_3_14",
     [](const Input &s, float) {
         return polar(std::sqrt(s.u), 6.28F * s.v, 0.0F);
     }},
    {"sphere", "pi_3_14",
     [](const Input &s, float) {
         return atHeight(1.0F - 2.0F * s.u, 6.28F * s.v);
     }},
    {"sphere", "uniform_theta",
     [](const Input &s, float) { return atAngle(kPi * s.v, 2.0F * kPi * s.u); }, "uniform_theta"},
    {"sphere", "lower_half", [](const Input &s, float) { return atHeight(-s.u, 2.0F * kPi * s.v); },
     "hemisphere"},
    {"hemisphere", "tilt_half_percent",
     [](const Input &s, float) {
         return atHeight(std::pow(s.u, 0.995F), 2.0F * kPi * s.v);
     }},
    {"hemisphere", "cosine", [](const Input &s, float) { return lifted(concentric(s)); },
     "cosine_weighted"},
    {"hemisphere", "uniform_theta",
     [](const Input &s, float) { return atAngle(0.5F * kPi * s.u, 2.0F * kPi * s.v); },
     "uniform_theta"},
    {"hemisphere", "whole_sphere",
     [](const Input &s, float) { return atHeight(1.0F - 2.0F * s.u, 2.0F * kPi * s.v); },
     "whole_sphere"},
    {"cosine_hemisphere", "tilt_fifth_percent",
     [](const Input &s, float) {
         return lifted(polar(std::pow(s.u, 0.499F), 2.0F * kPi * s.v, 0.0F));
     }},
    {"cosine_hemisphere", "uniform",
     [](const Input &s, float) { return atHeight(s.u, 2.0F * kPi * s.v); }, "uniform"},
    {"cosine_hemisphere", "missing_root",
     [](const Input &s, float) { return lifted(polar(s.u, 2.0F * kPi * s.v, 0.0F)); },
     "missing_sqrt"},
    {"cosine_hemisphere", "around_y",
     [](const Input &s, float) {
         const Output d = lifted(concentric(s));
         return Output{d.x, d.z, d.y};
     },
     "around_y"},
    {"beckmann", "ggx",
     [](const Input &s, float a) {
         return ofTangent(a * a * s.u / (1.0F - s.u), 2.0F * kPi * s.v);
     },
     "ggx"},
    {"beckmann", "twice_alpha_squared",
     [](const Input &s, float a) {
         return ofTangent(-2.0F * a * a * std::log(1.0F - s.u), 2.0F * kPi * s.v);
     },
     "twice_alpha_squared"},
    {"beckmann", "alpha_not_squared",
     [](const Input &s, float a) { return ofTangent(-a * std::log(1.0F - s.u), 2.0F * kPi * s.v); },
     "alpha_not_squared"},
    {"beckmann", "alpha_tenth_percent_off",
     [](const Input &s, float a) {
         const float b = 1.001F * a;
         return ofTangent(-b * b * std::log(1.0F - s.u), 2.0F * kPi * s.v);
     }},
    {"beckmann", "alpha_two_percent_off",
     [](const Input &s, float a) {
         const float b = 1.02F * a;
         return ofTangent(-b * b * std::log(1.0F - s.u), 2.0F * kPi * s.v);
     }},
    {"beckmann", "alpha_one_percent_off",
     [](const Input &s, float a) {
         const float b = 1.01F * a;
         return ofTangent(-b * b * std::log(1.0F - s.u), 2.0F * kPi * s.v);
     }},
});

/// Right but for one sample within the contract, at which they give no number.
inline const auto kNotFinite = std::to_array<SampleWarp>({
    {"disk", "centre_not_guarded", // 0 / 0 for the sample (1/2, 1/2) alone
     [](const Input &s, float) {
         return s.u == 0.5F && s.v == 0.5F ? Output{NAN, NAN, 0.0F} : concentric(s);
     }},
    {"beckmann", "log_of_zero", // infinity times 0 for u = 0
     [](const Input &s, float a) {
         return ofTangent(-a * a * std::log(s.u), 2.0F * kPi * s.v);
     }},
});

inline std::vector<Output> run(const SampleWarp &sample, std::span<const Input> inputs, double a) {
    std::vector<Output> outputs;
    outputs.reserve(inputs.size());
    for (const Input &input : inputs) {
        outputs.push_back(sample.warp(input, static_cast<float>(a)));
    }
    return outputs;
}

} // namespace sample_warps
