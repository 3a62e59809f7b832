// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/rubric/rubric.h>

#include "../target.h"

void fuzz::run(std::string_view bytes) {
    using namespace grader;
    static const std::vector<KnownCheck> kTable = {{"disk.density", "warp.disk", 0.01, 0.2},
                                                   {"disk.range", "warp.disk", 0, 0},
                                                   {"area.eval", "area_light", 0.02, 0.5}};
    try {
        Rubric rubric = parseRubric(std::string(bytes), "rubric.toml");
        resolveChecks(rubric, kTable);
        for (const RubricItem &item : rubric.items)
            require(item.points >= 0 && !item.checks.empty(), "an item has points and checks");
        summarize(rubric);
    } catch (const GraderError &) {
    }
}
