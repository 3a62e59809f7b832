// SPDX-License-Identifier: MIT
#include "comparison_report.h"

#include <grader/report/text_layout.h>
#include <grader/results/safe_text.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace grader {

namespace {

using Json = nlohmann::ordered_json;
using statistics::Tile;
using statistics::TileWelchResult;

constexpr std::size_t kWorstTiles = 5;

std::string paragraph(const std::string &text, const TerminalStyle &style) {
    std::string result;
    for (const std::string &line : wrapText(text, style.width > 4 ? style.width - 2 : 0))
        result += "  " + line + "\n";
    return result;
}

std::string heading(const Comparison &comparison, const TerminalStyle &style) {
    const char *const name = likenessName(comparison.likeness);
    if (!style.colour)
        return name;
    const char *const colour = comparison.likeness == Likeness::Alike       ? "\x1b[32m"
                               : comparison.likeness == Likeness::Different ? "\x1b[31m"
                                                                            : "\x1b[33m";
    return fmt::format("{}{}\x1b[0m", colour, name);
}

std::string percent(double fraction) {
    return fmt::format("{:.3f} %", 100 * fraction);
}

using Cell = std::string(const ChannelComparison &);
using TilesCell = std::string(const TileWelchResult &);

/// A row of the table; an empty cell says nothing of its channel.
struct Row {
    const char *name = nullptr;
    Cell *cell = nullptr;
    TilesCell *tilesCell = nullptr; ///< instead of `cell`: only where the tiles were tested

    std::string of(const ChannelComparison &channel) const {
        if (cell != nullptr)
            return cell(channel);
        return channel.tiles ? tilesCell(*channel.tiles) : std::string();
    }
};

std::string meanSquare(const TileWelchResult &tiles) {
    return fmt::format("{:.4f}", tiles.sumOfSquares / static_cast<double>(std::max<std::size_t>(
                                                          1, tiles.tilesTested)));
}

const Row kRows[] = {
    {"mean",
     [](const auto &c) {
         return fmt::format("{:.6g}", c.errors.mean);
     }},
    {"  of the reference",
     [](const auto &c) {
         return fmt::format("{:.6g}", c.errors.referenceMean);
     }},
    {"RMSE",
     [](const auto &c) {
         return fmt::format("{:.4g}", c.errors.rmse);
     }},
    {"relMSE",
     [](const auto &c) {
         return fmt::format("{:.4g}", c.errors.relMse);
     }},
    {"SMAPE",
     [](const auto &c) {
         return fmt::format("{:.4g}", c.errors.smape);
     }},
    {"mean, relative", nullptr,
     [](const auto &t) {
         return fmt::format("{:+.3f} %", 100 * t.globalRelativeError);
     }},
    {"  p", nullptr,
     [](const auto &t) {
         return fmt::format("{:.3g}", t.global.pValue);
     }},
    {"  smallest to be found", nullptr,
     [](const auto &t) {
         return percent(t.globalMde);
     }},
    {"scale",
     [](const auto &c) {
         return c.scale ? fmt::format("{:.5f} +- {:.5f}", 1 + c.scale->beta,
                                      1.96 * c.scale->standardError)
                        : std::string();
     }},
    {"tiles: largest |z|", nullptr,
     [](const auto &t) {
         return fmt::format("{:.2f}", std::abs(t.tiles[t.worstTile].score));
     }},
    {"  p", nullptr,
     [](const auto &t) {
         return fmt::format("{:.3g}", t.maxPValue);
     }},
    {"  mean z^2", nullptr, meanSquare},
    {"  p", nullptr,
     [](const auto &t) {
         return fmt::format("{:.3g}", t.sumPValue);
     }},
    {"  too skewed to judge", nullptr,
     [](const auto &t) {
         return fmt::format("{} of {}", t.tilesBeyondGate, t.tiles.size());
     }},
    {"  smallest to be found", nullptr,
     [](const auto &t) {
         return percent(t.tileMde);
     }},
    {"squared error / noise",
     [](const auto &c) {
         return c.noise ? fmt::format("{:.4f} (z {:+.1f})", c.noise->ratio, c.noise->z)
                        : std::string();
     }},
};

std::string table(const Comparison &comparison) {
    constexpr std::size_t kNameWidth = 24;
    constexpr std::size_t kCellWidth = 20;
    std::string text = "  " + padRight("", kNameWidth);
    for (const ChannelComparison &channel : comparison.channels)
        text += padLeft(channel.name, kCellWidth);
    text += '\n';
    for (const Row &row : kRows) {
        std::string line = "  " + padRight(row.name, kNameWidth);
        bool isEmpty = true;
        for (const ChannelComparison &channel : comparison.channels) {
            const std::string cell = row.of(channel);
            isEmpty = isEmpty && cell.empty();
            line += padLeft(cell, kCellWidth);
        }
        if (!isEmpty)
            text += line + '\n';
    }
    return text;
}

/// The tiles that stand out most, over all channels.
std::string worstTiles(const Comparison &comparison) {
    struct Entry {
        const char *channel;
        const Tile *tile;
    };

    std::vector<Entry> entries;
    for (const ChannelComparison &channel : comparison.channels) {
        if (!channel.tiles)
            continue;
        for (const Tile &tile : channel.tiles->tiles)
            entries.push_back({channel.name.c_str(), &tile});
    }
    if (entries.empty())
        return {};
    const std::size_t count = std::min(kWorstTiles, entries.size());
    std::partial_sort(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(count),
                      entries.end(), [](const Entry &a, const Entry &b) {
                          return std::abs(a.tile->score) > std::abs(b.tile->score);
                      });
    std::string text = "\n  worst tiles: channel, pixel (x, y), reference, difference, z\n";
    for (std::size_t i = 0; i < count; ++i) {
        const Tile &tile = *entries[i].tile;
        text +=
            fmt::format("    {}  ({:4}, {:4})  {:10.4g}  {:+10.3g}  {:+6.2f}{}\n",
                        entries[i].channel, tile.x, tile.y, tile.reference, tile.test.difference,
                        tile.score, tile.test.gateMet ? "" : "  too skewed to judge");
    }
    return text;
}

Json tilesJson(const TileWelchResult &result) {
    Json tiles = Json::array();
    for (const Tile &tile : result.tiles)
        tiles.push_back({{"x", tile.x},
                         {"y", tile.y},
                         {"reference", tile.reference},
                         {"difference", tile.test.difference},
                         {"standard_error", tile.test.standardError},
                         {"z", tile.score},
                         {"gate", tile.test.gateMet}});
    return {{"global",
             {{"relative_error", result.globalRelativeError},
              {"bound", result.globalBound},
              {"mde", result.globalMde},
              {"p", result.global.pValue}}},
            {"sum",
             {{"mean_z2", result.sumOfSquares /
                              static_cast<double>(std::max<std::size_t>(1, result.tilesTested))},
              {"p", result.sumPValue}}},
            {"max",
             {{"z", result.tiles[result.worstTile].score},
              {"p", result.maxPValue},
              {"bound", result.tileBound},
              {"mde", result.tileMde}}},
            {"beyond_gate", result.tilesBeyondGate},
            {"tiles", std::move(tiles)}};
}

Json channelJson(const ChannelComparison &channel) {
    Json json = {{"name", channel.name},
                 {"mean", channel.errors.mean},
                 {"reference_mean", channel.errors.referenceMean},
                 {"rmse", channel.errors.rmse},
                 {"relmse", channel.errors.relMse},
                 {"smape", channel.errors.smape},
                 {"largest", channel.errors.largest}};
    if (channel.scale)
        json["scale"] = {{"beta", channel.scale->beta},
                         {"standard_error", channel.scale->standardError},
                         {"bound", channel.scale->bound},
                         {"mde", channel.scale->mde}};
    if (channel.noise)
        json["noise"] = {
            {"ratio", channel.noise->ratio}, {"z", channel.noise->z}, {"p", channel.noise->pValue}};
    if (channel.tiles)
        json["test"] = tilesJson(*channel.tiles);
    return json;
}

} // namespace

std::string comparisonReport(const ComparedFiles &files, const Comparison &comparison,
                             const TerminalStyle &style) {
    std::string text = fmt::format("{} against {}: {}\n", safeLine(files.image),
                                   safeLine(fmt::format("{}", fmt::join(files.references, ", "))),
                                   heading(comparison, style));
    for (const std::string &reason : comparison.reasons)
        text += paragraph(reason, style);
    if (comparison.channels.empty())
        return text;
    text += '\n' + table(comparison);
    if (comparison.flip)
        text += fmt::format("  {}{:>20.4f}\n", padRight("FLIP", 24), *comparison.flip);
    if (comparison.pValue)
        text +=
            fmt::format("  {}{:>20.3g}\n", padRight("p of all together", 24), *comparison.pValue);
    text += worstTiles(comparison);
    if (comparison.isFiltered)
        text += '\n' + paragraph("The reference has no moments: both images are taken through the "
                                 "default Gaussian film, whose pixels share samples.",
                                 style);
    if (!comparison.channels.front().scale)
        return text;
    if (!comparison.scaleIsUnbiased)
        text += '\n' + paragraph("The scale is biased by the noise of the one reference; give two "
                                 "independent halves.",
                                 style);
    return text;
}

std::string comparisonJson(const ComparedFiles &files, const Comparison &comparison) {
    Json channels = Json::array();
    for (const ChannelComparison &channel : comparison.channels)
        channels.push_back(channelJson(channel));
    Json json = {{"schema", 1},
                 {"image", files.image},
                 {"references", files.references},
                 {"verdict", likenessName(comparison.likeness)},
                 {"reasons", comparison.reasons},
                 {"width", comparison.width},
                 {"height", comparison.height},
                 {"filtered", comparison.isFiltered},
                 {"channels", std::move(channels)}};
    if (comparison.flip)
        json["flip"] = *comparison.flip;
    if (comparison.pValue)
        json["p"] = *comparison.pValue;
    return escapeInvisible(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

} // namespace grader
