// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "configurations.h"
#include "runs.h"
#include "stock_scheme.h"

namespace warp_exam {

namespace {

/// What is found with fewer points than a battery takes would be found with all of them.
constexpr std::size_t kFewSamples = std::size_t{1} << 17U;

struct Row {
    int killed = 0;
    std::string by; ///< the steps that failed it, with the first seed
    bool stockAccepts = false;
    Distance distance; ///< of those that are said to be right
};

battery::TestResult test(const Configuration &item, std::uint64_t seed) {
    battery::TestOptions options;
    options.parameter = item.a;
    options.seed = seed;
    options.samples = kFewSamples;
    battery::TestResult result = battery::testWarp(item.warp, item.density, *item.target, options);
    if (result.verdict != battery::Status::Fail) {
        options.samples = battery::kDistributionSamples;
        result = battery::testWarp(item.warp, item.density, *item.target, options);
    }
    return result;
}

Row examine(const Configuration &item, int seeds) {
    Row row;
    for (int seed = 1; seed <= seeds; ++seed) {
        const battery::TestResult result = test(item, static_cast<std::uint64_t>(seed));
        row.killed += result.verdict == battery::Status::Fail ? 1 : 0;
        for (const battery::TestRow &step : result.rows) {
            if (seed == 1 && step.status == battery::Status::Fail) {
                row.by += (row.by.empty() ? "" : " ") + step.id;
            }
        }
    }
    row.stockAccepts = stockScheme(item).accepted;
    if (!item.equivalence.empty()) {
        row.distance = distanceFromRight(item);
    }
    return row;
}

struct Tally {
    int wrong = 0;
    int killed = 0;
    int stockKilled = 0;
    int equivalent = 0;
    bool good = true;
};

void print(const Configuration &item, const Row &row, int seeds, Tally &tally) {
    const std::string parameter = item.target->hasParameter ? fmt::format("{:g}", item.a) : "";
    std::string remark = row.by;
    bool right = row.killed == seeds;
    if (item.equivalence.empty()) {
        ++tally.wrong;
        tally.killed += right ? 1 : 0;
        tally.stockKilled += row.stockAccepts ? 0 : 1;
    } else {
        ++tally.equivalent;
        right = row.distance.isWithinRounding() && row.killed == 0;
        remark = fmt::format("= right: {} (points within {:.1e} of {:.1e}, pdf within {:.1e} of "
                             "{:.1e})",
                             item.equivalence, row.distance.warp, row.distance.warpTolerance,
                             row.distance.density, row.distance.densityTolerance);
    }
    tally.good = tally.good && right;
    fmt::print("{} {:<48} {:>4}  {}/{}  {:<8}  {}\n", right ? ' ' : '!', item.name, parameter,
               row.killed, seeds, row.stockAccepts ? "accepted" : "rejected", remark);
    std::fflush(stdout);
}

/// The stock scheme on right code, for the same table.
void printRight(const std::vector<Configuration> &items) {
    std::vector<StockVerdict> verdicts(items.size());
    forEach("stock scheme", items.size(),
            [&](std::size_t i) { verdicts[i] = stockScheme(items[i]); });
    int rejected = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (!verdicts[i].accepted) {
            ++rejected;
            fmt::print("  stock scheme rejects the right {} at a = {:g} (p = {:.2g})\n",
                       items[i].name, items[i].a, verdicts[i].pValue);
        }
    }
    fmt::print("{} right configurations: the stock scheme rejects {}\n", items.size(), rejected);
}

} // namespace

bool runPower(const PowerOptions &options) {
    std::vector<Configuration> items = wrongConfigurations();
    std::erase_if(items, [&](const Configuration &item) {
        return item.name.find(options.warp) == std::string::npos;
    });
    fmt::print("  {:<48} {:>4}  {}  {:<8}  found by\n", "wrong", "a", "ours", "stock");
    std::vector<Row> rows(items.size());
    std::vector<bool> done(items.size());
    std::size_t printed = 0;
    Tally tally;
    std::mutex mutex;
    forEach("wrong configurations", items.size(), [&](std::size_t i) {
        Row row = examine(items[i], options.seeds);
        const std::scoped_lock lock(mutex);
        rows[i] = std::move(row);
        done[i] = true;
        for (; printed < items.size() && done[printed]; ++printed) {
            print(items[printed], rows[printed], options.seeds, tally);
        }
    });
    fmt::print("{} wrong configurations: ours kills {} with each of {} seeds, the stock scheme {}; "
               "{} more are right at their parameter\n",
               tally.wrong, tally.killed, options.seeds, tally.stockKilled, tally.equivalent);
    if (options.warp.empty()) {
        printRight(rightConfigurations());
    }
    return tally.good;
}

} // namespace warp_exam
