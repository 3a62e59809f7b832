// SPDX-License-Identifier: MIT
#include "nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace grader {

namespace {

/// Levenshtein's distance, one row of its table at a time.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::string nearestName(std::string_view name, const std::vector<std::string> &known) {
    std::string nearest;
    std::size_t best = (name.size() + 3) / 4 + 1;
    for (const std::string &candidate : known) {
        const std::size_t distance = editDistance(name, candidate);
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view name, const std::vector<std::string> &known) {
    const std::string nearest = nearestName(name, known);
    if (!nearest.empty())
        return fmt::format(" (did you mean \"{}\"?)", nearest);
    return fmt::format(" (known: {})", fmt::join(known, ", "));
}

} // namespace grader
