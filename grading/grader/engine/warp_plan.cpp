// SPDX-License-Identifier: MIT
#include "warp_plan.h"

#include <catalog/warp_catalog.h>
#include <grader/engine/groups.h>

#include <fmt/format.h>

namespace grader {

namespace {

constexpr std::string_view kClass = "Warp::";

/// The name of a member of nori::Warp in the linker's language (Itanium C++ ABI, 5.1).
/// \param domain  mangled type of the first argument, which is passed by reference
std::string symbolOf(const std::string &function, const char *domain, bool hasParameter) {
    return fmt::format("_ZN4nori4Warp{}{}ERK{}{}", function.size(), function, domain,
                       hasParameter ? "f" : "");
}

} // namespace

VariantPlan mendedWarps(const std::set<std::string> &items) {
    constexpr char kPoint2f[] = "NS_6TPointIfLi2EEE";
    constexpr char kVector3f[] = "NS_7TVectorIfLi3EEE";
    VariantPlan plan = studentPlan(findGroup("warp"));
    plan.name = fmt::format("ours: {}", fmt::join(items, ", "));
    FunctionSwap swap{findGroup("warp").own.front(), {}, {}};
    for (const catalog::WarpEntry &warp : catalog::warpCatalog()) {
        const std::string sample = warp.warpFunction.substr(kClass.size());
        const std::string density = warp.densityFunction.substr(kClass.size());
        if (items.count(warp.rubricId) == 0) {
            swap.kept.insert(swap.kept.end(), {sample, density});
            continue;
        }
        swap.symbols.push_back(symbolOf(sample, kPoint2f, warp.hasParameter));
        swap.symbols.push_back(
            symbolOf(density, warp.dimension == 2 ? kPoint2f : kVector3f, warp.hasParameter));
    }
    plan.swap = std::move(swap);
    return plan;
}

} // namespace grader
