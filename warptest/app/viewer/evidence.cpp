// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <viewer/evidence.h>
#include <viewer/report_json.h>
#include <window/color_map.h>
#include <window/picture.h>

namespace viewer {

namespace {

constexpr int kWidth = 1000;
constexpr int kHeight = 560;
constexpr int kMargin = 20;
constexpr int kMapPixels = 288;
constexpr int kLine = 22;
constexpr std::uint32_t kInk = 0xff282420;
constexpr std::uint32_t kSparse = 0xff808080;
constexpr double kResidualRange = 4.0;

void drawMap(window::Picture &picture, int left, int top, const TestReport &report, int which) {
    const battery::Maps &maps = report.maps;
    const int side = maps.side;
    for (int cell = 0; cell < side * side; ++cell) {
        const auto i = static_cast<std::size_t>(cell);
        const double scale = maps.largest > 0.0 ? maps.largest : 1.0;
        std::uint32_t color =
            window::viridis((which == 0 ? maps.observed[i] : maps.expected[i]) / scale);
        if (which == 2) {
            color = maps.sparse[i] ? kSparse : window::diverging(maps.residual[i] / kResidualRange);
        }
        // the cells' edges, rounded, so that they touch whatever their number
        const int x = cell % side * kMapPixels / side;
        const int y = (side - 1 - cell / side) * kMapPixels / side;
        picture.fill(left + x, top + y, (cell % side + 1) * kMapPixels / side - x,
                     (side - cell / side) * kMapPixels / side - y, color);
    }
}

window::Picture drawPicture(const Subject &subject, const TestReport &report) {
    window::Picture picture(kWidth, kHeight, 0xffffffff);
    const catalog::WarpEntry &truth = *subject.truth;
    const std::string parameter =
        truth.hasParameter ? fmt::format("α = {:.6g}, ", report.settings.parameter) : "";
    picture.write(kMargin, kMargin,
                  fmt::format("{}: {}", truth.warpFunction, label(report.result.verdict)), kInk);
    picture.write(kMargin, kMargin + kLine, report.result.headline, kInk);
    picture.write(kMargin, kMargin + 2 * kLine,
                  fmt::format("{}code of {}, seed {}, {} points in the maps", parameter,
                              subject.from, report.settings.seed, report.maps.points),
                  kInk);
    const int top = kMargin + 4 * kLine;
    const std::string titles[] = {fmt::format("Observed, 0 … {:.4g}", report.maps.largest),
                                  "Expected, same colours", "(O−E)/√E, blue −4 … orange +4"};
    for (int which = 0; which < 3; ++which) {
        const int left = kMargin + which * (kMapPixels + kMargin);
        picture.write(left, top - kLine, titles[which], kInk);
        if (!report.maps.observed.empty()) {
            drawMap(picture, left, top, report, which);
        }
    }
    int y = top + kMapPixels + kMargin / 2;
    const auto line = [&](const std::string &text) {
        picture.write(kMargin, y, text, kInk);
        y += kLine;
    };
    if (!report.result.error.empty()) {
        line(report.result.error);
    }
    for (const battery::TestRow &row : report.result.rows) {
        if (row.id == "histogram" || row.status == battery::Status::Fail) {
            line(fmt::format("{}  {}: {} ({})", label(row.status), row.name, row.value,
                             row.expected));
        }
    }
    line(report.result.power);
    return picture;
}

} // namespace

std::string evidenceName(const catalog::WarpEntry &truth) {
    constexpr std::string_view kPrefix = "Warp::squareTo";
    return std::string(truth.warpFunction.substr(kPrefix.size()));
}

std::string writeEvidence(const Subject &subject, const TestReport &report,
                          const std::string &folder) {
    const std::filesystem::path directory = folder;
    std::filesystem::create_directories(directory);
    const std::string stem = (directory / evidenceName(*subject.truth)).string();
    const std::string json = documentJson({{&subject, report}});
    drawPicture(subject, report).writePng(stem + ".png", "warptest", json);
    std::ofstream file(stem + ".json", std::ios::binary);
    file << json;
    file.close();
    if (!file) {
        throw std::runtime_error(stem + ".json: cannot be written");
    }
    return stem + ".png";
}

} // namespace viewer
