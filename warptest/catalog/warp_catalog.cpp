// SPDX-License-Identifier: MIT
#include "warp_catalog.h"

#include <catalog/directional_warps.h>
#include <catalog/planar_warps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace catalog {

std::span<const WarpEntry> warpCatalog() {
    static const std::array<WarpEntry, 8> entries{planar::square(),
                                                  planar::tent(),
                                                  planar::disk(),
                                                  planar::triangle(),
                                                  directional::sphere(),
                                                  directional::hemisphere(),
                                                  directional::cosineHemisphere(),
                                                  directional::beckmann()};
    return entries;
}

const WarpEntry *findWarp(std::string_view id) {
    for (const WarpEntry &entry : warpCatalog()) {
        if (entry.id == id) {
            return &entry;
        }
    }
    return nullptr;
}

const WarpEntry &requireWarp(std::string_view id) {
    if (const WarpEntry *entry = findWarp(id)) {
        return *entry;
    }
    std::string message = "unknown warp \"" + std::string(id) + "\"; known:";
    for (const WarpEntry &entry : warpCatalog()) {
        message += " " + std::string(entry.id);
    }
    throw std::invalid_argument(message);
}

Placement placement(const WarpEntry &entry, const Point &p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        return Placement::NotFinite;
    }
    if (entry.dimension == 3 &&
        std::fabs(std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) - 1.0) > kNormTolerance) {
        return Placement::OffNorm;
    }
    return entry.margin(p) < -kSupportTolerance ? Placement::Outside : Placement::Inside;
}

double edgeConditioning(const WarpEntry &entry, double a) {
    return entry.edgeConditioning ? entry.edgeConditioning(a) : 0.0;
}

double distributionTolerance(const WarpEntry &entry, double a, int uBins) {
    return std::max(0.003, uBins * kFloatRounding * edgeConditioning(entry, a));
}

double stratifiedTolerance(const WarpEntry &entry, double a, int side) {
    const double noise = 5e-4 * std::max(1.0, std::pow(1024.0 / side, 1.5));
    return std::max(noise, 4.0 * kFloatRounding * edgeConditioning(entry, a));
}

namespace {

/// Permutation k of (a, b, c), in the order identity, swap, ...
Point permuteBarycentrics(const Point &p, int k) {
    const std::array<double, 3> b{p.x, p.y, 1.0 - p.x - p.y};
    constexpr std::array<std::array<std::size_t, 2>, 6> kOrder{
        {{0, 1}, {1, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 1}}};
    const auto &order = kOrder[static_cast<std::size_t>(k)];
    return {b[order[0]], b[order[1]], 0.0};
}

/// Symmetry k < 8 of the square around the origin.
Point dihedral(Point p, int k) {
    if (k >= 4) {
        std::swap(p.x, p.y);
    }
    for (int turns = k % 4; turns > 0; --turns) {
        p = {-p.y, p.x, p.z};
    }
    return p;
}

} // namespace

int symmetryCount(const WarpEntry &entry) {
    if (entry.id == "triangle") {
        return 6;
    }
    return entry.id == "sphere" ? 16 : 8;
}

Point symmetry(const WarpEntry &entry, const Point &p, int k) {
    if (entry.id == "triangle") {
        return permuteBarycentrics(p, k);
    }
    if (entry.id == "square") {
        const Point centred = dihedral({p.x - 0.5, p.y - 0.5, 0.0}, k);
        return {centred.x + 0.5, centred.y + 0.5, 0.0};
    }
    Point moved = dihedral(p, k % 8);
    if (k >= 8) {
        moved.z = -moved.z;
    }
    return moved;
}

} // namespace catalog
