// SPDX-License-Identifier: MIT
#include "warp_plan.h"

#include <catalog/warp_catalog.h>
#include <grader/engine/groups.h>

#include <fmt/format.h>

namespace grader {

namespace {

constexpr char kPoint2f[] = "NS_6TPointIfLi2EEE";
constexpr char kVector3f[] = "NS_7TVectorIfLi3EEE";

/// \param function  a member of nori::Warp
/// \param domain    type of its first argument, which is passed by reference, in the linker's
///                  language (Itanium C++ ABI, 5.1)
LinkedFunction linked(const std::string &function, const char *domain, bool hasParameter) {
    const std::string member = function.substr(std::string_view("Warp::").size());
    return {function, fmt::format("_ZN4nori4Warp{}{}ERK{}{}", member.size(), member, domain,
                                  hasParameter ? "f" : "")};
}

} // namespace

VariantPlan mendedWarps(VariantPlan plan, const std::set<std::string> &functions) {
    FunctionSwap swap{findGroup("warp").own.front(), {}, {}};
    const auto add = [&](const std::string &function, const char *domain, bool hasParameter) {
        (functions.count(function) != 0 ? swap.ours : swap.theirs)
            .push_back(linked(function, domain, hasParameter));
    };
    for (const catalog::WarpEntry &warp : catalog::warpCatalog()) {
        add(warp.warpFunction, kPoint2f, warp.hasParameter);
        add(warp.densityFunction, warp.dimension == 2 ? kPoint2f : kVector3f, warp.hasParameter);
    }
    plan.name = fmt::format("ours: {}", fmt::join(functions, ", "));
    plan.swap = std::move(swap);
    return plan;
}

} // namespace grader
