// SPDX-License-Identifier: MIT
#include "point_maps.h"

#include <battery/maps.h>
#include <catalog/warp_catalog.h>

#include <fmt/format.h>

#include <vector>

#include "heat_map.h"
#include "html.h"

namespace grader {

std::string pointMaps(const ItemResult &item) {
    std::string html;
    for (const CheckResult &check : item.checks) {
        if (!check.map)
            continue;
        const PointMap &map = *check.map;
        const catalog::WarpEntry &truth = catalog::requireWarp(map.warp);
        const battery::Maps maps = battery::mapsOfCounts(
            truth, map.parameter, std::vector<double>(map.counts.begin(), map.counts.end()),
            map.points);
        html += fmt::format("<div class=\"evidence\">\n<h3>Where the points of <code>{}</code> "
                            "fall{}</h3>\n{}</div>\n",
                            escapeHtml(truth.warpFunction),
                            truth.hasParameter ? fmt::format(", alpha = {:g}", map.parameter) : "",
                            mapFigures(maps));
    }
    return html;
}

} // namespace grader
