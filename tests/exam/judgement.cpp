// SPDX-License-Identifier: MIT
#include "judgement.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>

namespace exam {

namespace {

constexpr const char *kHuman = "a person must look";

bool contains(const std::vector<std::string> &ids, const std::string &id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool costs(const GradedCheck &check) {
    return check.found() && check.severity != "blemish" && check.score < 1;
}

/// Whether the item lost what a mistake of this kind has to cost.
bool lostRightly(const Patch &patch, const GradedItem &item) {
    switch (patch.cost) {
    case Patch::Cost::Nothing:
        return item.isFull();
    case Patch::Cost::Visible:
        return !item.isFull() &&
               std::any_of(item.checks.begin(), item.checks.end(), [](const GradedCheck &check) {
                   return costs(check) && check.severity == "visible";
               });
    case Patch::Cost::Latent:
        return !item.isFull() &&
               std::all_of(item.checks.begin(), item.checks.end(), [](const GradedCheck &check) {
                   return !costs(check) || check.severity == "latent";
               });
    case Patch::Cost::Blemish:
        return item.isFull() && std::any_of(item.checks.begin(), item.checks.end(),
                                            [](const GradedCheck &check) { return check.found(); });
    }
    return false;
}

/// Of the item that is meant.
void judgeItem(const Patch &patch, const GradedItem &item, Judgement &judgement) {
    // Until a person has looked nothing is found, and nothing lost.
    judgement.asExpected = lostRightly(patch, item) && !item.needsHuman();
    judgement.lost = patch.cost == Patch::Cost::Blemish ? judgement.asExpected
                                                        : !item.isFull() && !item.needsHuman();
    const std::vector<std::string> told = diagnosesOf(item);
    for (std::size_t i = 0; i < told.size() && judgement.diagnosisRank == 0; ++i) {
        if (contains(patch.diagnoses, told[i])) {
            judgement.diagnosisRank = i + 1;
            judgement.diagnosis = told[i];
        }
    }
    judgement.got += fmt::format("{} {:.4g}/{:g}", item.id, item.points, item.max);
    if (judgement.lost)
        judgement.got += fmt::format(" \"{}\"", told.empty() ? item.reason : told.front());
    if (item.needsHuman())
        judgement.got += fmt::format(": {}: {}", kHuman, item.reason);
}

bool isExcused(const Patch &patch, const GradedItem &item) {
    return contains(patch.missing, item.id) && item.verdict == "missing";
}

} // namespace

const std::vector<std::string> &catchAlls() {
    static const std::vector<std::string> ids = {
        "warp.density_of_points",
        "warp.out_of_domain",
        "warp.pdf_wrong",
        "mesh.off_surface",
        "mesh.not_uniform_in_triangle",
        "mesh.normal_not_interpolated",
        "mesh.uv_wrong",
        "mesh.pdf_factor",
        "area.texture_uv",
        "area.pdf_wrong",
        "area.value_wrong",
        "area.wi_wrong",
        "environment.not_uniform",
        "environment.value_wrong",
        "environment.eval_changed",
        "ems.part_of_image",
        "importance.not_proportional",
        "importance.pdf_mismatch",
        "importance.pdf_emitter",
        "importance.not_divided",
        "importance.other_noise",
    };
    return ids;
}

std::vector<std::string> diagnosesOf(const GradedItem &item) {
    if (!item.diagnoses.empty())
        return item.diagnoses;
    // The order of the sentences in the reason: what costs most, visible before latent.
    std::vector<GradedCheck> found;
    std::copy_if(item.checks.begin(), item.checks.end(), std::back_inserter(found),
                 [](const GradedCheck &check) { return check.found(); });
    const auto rank = [&](const GradedCheck &check) {
        const bool told = item.reason.rfind(check.message, 0) == 0;
        const int severity = check.severity == "visible" ? 0 : check.severity == "latent" ? 1 : 2;
        return std::tuple(told ? 0 : 1, severity, check.score);
    };
    std::stable_sort(found.begin(), found.end(),
                     [&](const GradedCheck &a, const GradedCheck &b) { return rank(a) < rank(b); });
    std::vector<std::string> told;
    for (const GradedCheck &check : found) {
        std::copy_if(check.diagnoses.begin(), check.diagnoses.end(), std::back_inserter(told),
                     [&](const std::string &id) { return !contains(told, id); });
    }
    return told;
}

Judgement judge(const Patch &patch, const Graded &graded) {
    Judgement judgement;
    judgement.asExpected = patch.item.empty();
    for (const GradedItem &item : graded.items) {
        if (item.id == patch.item) {
            judgeItem(patch, item, judgement);
            continue;
        }
        const bool remarked =
            patch.item.empty() &&
            (!diagnosesOf(item).empty() ||
             std::any_of(item.checks.begin(), item.checks.end(), [](const GradedCheck &check) {
                 return check.found() && check.severity != "blemish";
             }));
        judgement.humans += item.needsHuman() ? 1 : 0;
        const bool isRight = item.isFull() && !remarked;
        if ((isRight && !item.needsHuman()) || isExcused(patch, item))
            continue;
        // Downstream of a mistake a person may have to look, but not at what is right.
        if (!isRight || patch.item.empty())
            judgement.othersFull = false;
        judgement.got +=
            fmt::format("; {} {:.4g}/{:g}: {}{}", item.id, item.points, item.max,
                        item.needsHuman() ? std::string(kHuman) + ": " : "", item.reason);
    }
    judgement.asExpected = judgement.asExpected && judgement.othersFull;
    return judgement;
}

} // namespace exam
