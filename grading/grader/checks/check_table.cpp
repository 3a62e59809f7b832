// SPDX-License-Identifier: MIT
#include <algorithm>

#include "check_groups.h"

namespace grader {

const std::vector<Check> &checkTable() {
    static const std::vector<Check> table = [] {
        // Of direct_ems, closed forms and repeated images come before images, which take seconds: a
        // gross mistake is known early.
        std::vector<Check> checks;
        for (auto *group : {warpChecks, meshChecks, areaChecks, environmentChecks, sceneChecks,
                            directEmsChecks, repeatChecks, imageChecks, farShadowChecks,
                            relationChecks, noiseChecks, importanceChecks}) {
            for (Check &check : group())
                checks.push_back(std::move(check));
        }
        return checks;
    }();
    return table;
}

const Check *findCheck(std::string_view id) {
    const std::vector<Check> &table = checkTable();
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const Check &check) { return check.id == id; });
    return found != table.end() ? &*found : nullptr;
}

} // namespace grader
