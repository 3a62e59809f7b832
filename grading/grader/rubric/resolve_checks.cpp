// SPDX-License-Identifier: MIT
#include <grader/error.h>

#include <fmt/format.h>

#include <algorithm>

#include "nearest_name.h"
#include "rubric.h"

namespace grader {

namespace {

RubricCheck resolve(const KnownCheck &known, const CheckOverride *change) {
    RubricCheck check;
    check.id = known.id;
    check.tolerance = known.tolerance;
    check.gross = known.gross;
    if (change == nullptr)
        return check;
    check.severity = change->severity.value_or(check.severity);
    check.weight = change->weight.value_or(check.weight);
    check.tolerance = change->tolerance.value_or(check.tolerance);
    check.gross = change->gross.value_or(check.gross);
    check.keeps = change->keeps.value_or(check.keeps);
    if ((change->tolerance || change->gross) && check.tolerance >= check.gross)
        throw GraderError(fmt::format("{}: {}: tolerance {} must be below gross {}", change->where,
                                      check.id, check.tolerance, check.gross));
    return check;
}

/// \throws GraderError  if `change` is for a check that is unknown or another item's
void requireKnown(const CheckOverride &change, const RubricItem &item,
                  const std::vector<KnownCheck> &table) {
    std::vector<std::string> ofItem;
    for (const KnownCheck &known : table) {
        if (known.item == item.id)
            ofItem.push_back(known.id);
    }
    if (std::find(ofItem.begin(), ofItem.end(), change.id) != ofItem.end())
        return;
    const auto elsewhere = std::find_if(
        table.begin(), table.end(), [&](const KnownCheck &known) { return known.id == change.id; });
    if (elsewhere != table.end())
        throw GraderError(fmt::format(R"({}: check "{}" belongs to item "{}", not "{}")",
                                      change.where, change.id, elsewhere->item, item.id));
    throw GraderError(fmt::format("{}: there is no check \"{}\"{}", change.where, change.id,
                                  suggestion(change.id, ofItem)));
}

} // namespace

void resolveChecks(Rubric &rubric, const std::vector<KnownCheck> &table) {
    std::vector<std::string> itemNames;
    for (const KnownCheck &known : table) {
        if (std::find(itemNames.begin(), itemNames.end(), known.item) == itemNames.end())
            itemNames.push_back(known.item);
    }
    for (RubricItem &item : rubric.items) {
        if (std::find(itemNames.begin(), itemNames.end(), item.id) == itemNames.end())
            throw GraderError(fmt::format("{}: no check judges an item \"{}\"{}", item.where,
                                          item.id, suggestion(item.id, itemNames)));
        for (const CheckOverride &change : item.overrides)
            requireKnown(change, item, table);
        item.checks.clear();
        for (const KnownCheck &known : table) {
            if (known.item != item.id)
                continue;
            const auto change =
                std::find_if(item.overrides.begin(), item.overrides.end(),
                             [&](const CheckOverride &entry) { return entry.id == known.id; });
            item.checks.push_back(
                resolve(known, change != item.overrides.end() ? &*change : nullptr));
        }
    }
}

Rubric withItems(const Rubric &rubric, const std::vector<std::string> &ids) {
    if (ids.empty())
        return rubric;
    std::vector<std::string> known;
    for (const RubricItem &item : rubric.items)
        known.push_back(item.id);
    for (const std::string &id : ids) {
        if (std::find(known.begin(), known.end(), id) == known.end())
            throw GraderError(fmt::format(R"(the rubric "{}" has no item "{}"{})", rubric.id, id,
                                          suggestion(id, known)));
    }
    Rubric result = rubric;
    result.items.clear();
    double points = 0;
    for (const RubricItem &item : rubric.items) {
        if (std::find(ids.begin(), ids.end(), item.id) == ids.end())
            continue;
        result.items.push_back(item);
        points += item.points;
    }
    result.cap = std::min(rubric.cap, points);
    return result;
}

} // namespace grader
