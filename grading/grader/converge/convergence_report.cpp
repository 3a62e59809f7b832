// SPDX-License-Identifier: MIT
#include "convergence_report.h"

#include <grader/report/text_layout.h>
#include <grader/results/safe_text.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kNarrow = 1.96; ///< deviations of a 95 % interval

std::string ratioText(const std::optional<statistics::RatioEstimate> &ratio) {
    return ratio ? fmt::format("{:.3f} +- {:.3f}", ratio->ratio, kNarrow * ratio->standardError)
                 : std::string("-");
}

Json ratioJson(const statistics::RatioEstimate &ratio) {
    return {{"ratio", ratio.ratio}, {"standard_error", ratio.standardError}};
}

} // namespace

const char *convergenceVerdict(const statistics::ConvergenceFit &fit) {
    if (fit.isMonteCarlo())
        return "converges as 1/sqrt(n)";
    return fit.isOtherwise() ? "does not" : "cannot tell";
}

std::string convergenceTable(const std::vector<Convergence> &all) {
    std::size_t width = 20;
    for (const Convergence &one : all)
        width = std::max(width, displayWidth(safeLine(one.label)));
    std::string text =
        fmt::format("  {} {:>7} {:>18} {:>16} {:>10} {:>11} {:>10} {:>16}  {}\n",
                    padRight("", width), "slope", "99.99 % interval", "between/within", "variance",
                    "CPU us/spp", "efficiency", "variance gain", "verdict");
    for (const Convergence &one : all) {
        text +=
            fmt::format("  {} {:>7.4f} {:>18} {:>16} {:>10.4g} {:>11.4g} {:>10.4g} {:>16}  {}\n",
                        padRight(safeLine(one.label), width), one.fit.slope,
                        fmt::format("{:.4f} {:.4f}", one.fit.low, one.fit.high),
                        ratioText(one.betweenWithin), one.variance, 1e6 * one.cpuSeconds,
                        one.efficiency, ratioText(one.gain), convergenceVerdict(one.fit));
    }
    return text;
}

std::string convergenceJson(const ConvergencePlan &plan, const std::vector<Convergence> &all) {
    Json curves = Json::array();
    for (const Convergence &one : all) {
        Json points = Json::array();
        for (const statistics::ErrorPoint &point : one.fit.points)
            points.push_back({{"spp", point.samples},
                              {"rmse", point.rmse},
                              {"low", point.low},
                              {"high", point.high}});
        Json curve = {
            {"label", one.label},           {"scene", one.scene},
            {"integrator", one.integrator}, {"verdict", convergenceVerdict(one.fit)},
            {"slope", one.fit.slope},       {"slope_low", one.fit.low},
            {"slope_high", one.fit.high},   {"slope_standard_error", one.fit.standardError},
            {"variance", one.variance},     {"cpu_seconds_per_spp", one.cpuSeconds},
            {"efficiency", one.efficiency}, {"points", std::move(points)}};
        if (one.betweenWithin)
            curve["between_within"] = ratioJson(*one.betweenWithin);
        if (one.gain)
            curve["variance_gain"] = ratioJson(*one.gain);
        curves.push_back(std::move(curve));
    }
    const Json json = {{"schema", 1},
                       {"seed", plan.seed},
                       {"replicates", plan.replicates},
                       {"width", plan.width},
                       {"curves", std::move(curves)}};
    return escapeInvisible(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

plot::LogLogPlot convergencePlot(const std::vector<Convergence> &all) {
    plot::LogLogPlot plot;
    plot.title = "Error against samples";
    plot.xLabel = "samples per pixel";
    plot.yLabel = "RMSE / deviation of one sample of the reference";
    plot.guideSlope = -0.5;
    for (const Convergence &one : all) {
        plot::Series series{fmt::format("{} ({:.3f})", one.label, one.fit.slope), {}};
        for (const statistics::ErrorPoint &point : one.fit.points)
            series.points.push_back({point.samples, point.rmse, point.low, point.high});
        plot.series.push_back(std::move(series));
    }
    return plot;
}

} // namespace grader
