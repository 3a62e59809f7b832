// SPDX-License-Identifier: MIT
#include "dump.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <span>

namespace {

/// Where the centre of a column (axis 0) or row (axis 1) is.
double centre(const battery::Maps &maps, std::size_t axis, int index) {
    const battery::DomainMap &domain = maps.domain;
    return domain.low.at(axis) +
           (domain.high.at(axis) - domain.low.at(axis)) * (index + 0.5) / maps.side;
}

double parameterOf(const viewer::Tested &test) {
    return test.subject->truth->hasParameter ? test.report.settings.parameter : 0.0;
}

std::string matlabMatrix(const battery::Maps &maps, std::span<const double> values) {
    std::string text = "[";
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool endsRow = (i + 1) % static_cast<std::size_t>(maps.side) == 0;
        text += fmt::format("{:.9g}{}", values[i], endsRow ? ";\n" : " ");
    }
    return text + "];\n";
}

std::string matlab(const std::vector<viewer::Tested> &tests) {
    std::string text = "% Counts of warptest; rows go up, columns to the right.\n";
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const viewer::Tested &test = tests[i];
        const battery::Maps &maps = test.report.maps;
        const std::string prefix = tests.size() > 1 ? fmt::format("tests({}).", i + 1) : "";
        text += fmt::format("{0}warp = '{1}';\n{0}parameter = {2:.9g};\n{0}sampleCount = {3};\n"
                            "{0}obsFrequencies = {4}{0}expFrequencies = {5}",
                            prefix, test.subject->truth->id, parameterOf(test), maps.points,
                            matlabMatrix(maps, maps.observed), matlabMatrix(maps, maps.expected));
    }
    return text;
}

std::string csv(const std::vector<viewer::Tested> &tests) {
    std::string text = "warp,parameter,column,row,x,y,observed,expected,residual\n";
    for (const viewer::Tested &test : tests) {
        const battery::Maps &maps = test.report.maps;
        for (std::size_t i = 0; i < maps.observed.size(); ++i) {
            const int column = static_cast<int>(i) % maps.side;
            const int row = static_cast<int>(i) / maps.side;
            text += fmt::format("{},{:.9g},{},{},{:.9g},{:.9g},{:.0f},{:.9g},{}\n",
                                test.subject->truth->id, parameterOf(test), column, row,
                                centre(maps, 0, column), centre(maps, 1, row), maps.observed[i],
                                maps.expected[i],
                                maps.sparse[i] ? "" : fmt::format("{:.6g}", maps.residual[i]));
        }
    }
    return text;
}

std::string json(const std::vector<viewer::Tested> &tests) {
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    for (const viewer::Tested &test : tests) {
        const battery::Maps &maps = test.report.maps;
        document.push_back({{"warp", test.subject->truth->id},
                            {"parameter", parameterOf(test)},
                            {"rows", maps.side},
                            {"points", maps.points},
                            {"x", {maps.domain.low[0], maps.domain.high[0]}},
                            {"y", {maps.domain.low[1], maps.domain.high[1]}},
                            {"observed", maps.observed},
                            {"expected", maps.expected}});
    }
    return document.dump() + "\n";
}

} // namespace

std::string dumpText(DumpFormat format, const std::vector<viewer::Tested> &tests) {
    switch (format) {
    case DumpFormat::Matlab:
        return matlab(tests);
    case DumpFormat::Csv:
        return csv(tests);
    case DumpFormat::Json:
        return json(tests);
    case DumpFormat::None:
        break;
    }
    return {};
}
