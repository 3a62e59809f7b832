// SPDX-License-Identifier: MIT
#include "summary.h"

#include <grader/text_file.h>
#include <statistics/binomial.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace exam {

namespace {

/// How often something held.
struct Rate {
    std::string what;
    double least = 0; ///< of all, that is wanted
    std::size_t held = 0, all = 0;

    void add(bool holds) {
        held += holds ? 1 : 0;
        ++all;
    }

    std::string describe() const {
        const statistics::Interval bounds = statistics::clopperPearson(held, all);
        return fmt::format("{}: {} of {} = {:.1f} % (95 %: {:.1f} to {:.1f} %){}", what, held, all,
                           100 * part(), 100 * bounds.lower, 100 * bounds.upper,
                           least > 0 ? fmt::format("; at least {:.0f} % is wanted", 100 * least)
                                     : "");
    }

    bool isReached() const { return all > 0 && part() >= least; }

private:
    double part() const { return static_cast<double>(held) / static_cast<double>(all); }
};

bool isCatchAll(const std::string &id) {
    return std::find(catchAlls().begin(), catchAlls().end(), id) != catchAlls().end();
}

bool isMutant(const PatchRecord &record) {
    return record.patch.cost != Patch::Cost::Nothing;
}

/// Whether it has to lose points.
bool mustCost(const PatchRecord &record) {
    return isMutant(record) && record.patch.cost != Patch::Cost::Blemish;
}

/// Those of which something was measured.
std::vector<Rate> ratesOf(const std::vector<PatchRecord> &records) {
    Rate lost{"mutants that lose points", 1};
    Rate exact{"mutants that cost as much as they should, on exactly the right item", 0.98};
    Rate first{"first diagnosis right, of mutants that have one", 0.85};
    Rate specific{"first diagnosis right, and no catch-all, of the same"};
    Rate three{"diagnosis right within three", 0.95};
    Rate again{"own item with further seeds: gradings as expected", 0.98};
    Rate lostAgain{"own item with further seeds: gradings that lose points", 1};
    Rate always{"mutants as expected with every seed"};
    Rate remarks{"blemishes that are remarked on and cost nothing", 1};
    Rate whole{"gradings of correct variants that lose nothing", 1};
    Rate variants{"correct variants that never lose anything", 1};
    for (const PatchRecord &record : records) {
        const Patch &patch = record.patch;
        for (const Judgement &judgement : record.item) {
            again.add(judgement.asExpected);
            if (mustCost(record))
                lostAgain.add(judgement.lost);
        }
        if (isMutant(record) && !(record.whole.empty() && record.item.empty()))
            always.add(record.asExpected());
        if (record.whole.empty())
            continue;
        const Judgement &judgement = record.whole.front();
        switch (patch.cost) {
        case Patch::Cost::Nothing:
            for (const Judgement &each : record.whole)
                whole.add(each.asExpected);
            variants.add(record.asExpected());
            continue;
        case Patch::Cost::Blemish:
            remarks.add(judgement.asExpected);
            break;
        default:
            lost.add(judgement.lost);
            exact.add(judgement.asExpected);
        }
        if (patch.diagnoses.empty())
            continue;
        first.add(judgement.diagnosisRank == 1);
        specific.add(judgement.diagnosisRank == 1 && !isCatchAll(judgement.diagnosis));
        three.add(judgement.diagnosisRank >= 1 && judgement.diagnosisRank <= 3);
    }
    std::vector<Rate> rates;
    for (const Rate &rate : {lost, exact, first, specific, three, again, lostAgain, always, remarks,
                             whole, variants}) {
        if (rate.all > 0)
            rates.push_back(rate);
    }
    return rates;
}

/// The rates, and of mutants what the rates leave out.
std::vector<std::string> findingsOf(const std::vector<PatchRecord> &records) {
    std::vector<std::string> findings;
    for (const Rate &rate : ratesOf(records))
        findings.push_back(rate.describe());
    const auto remarks = std::count_if(records.begin(), records.end(), [](const auto &record) {
        return record.patch.cost == Patch::Cost::Blemish;
    });
    const auto unnamed = std::count_if(records.begin(), records.end(), [](const auto &record) {
        return isMutant(record) && record.patch.diagnoses.empty();
    });
    if (std::any_of(records.begin(), records.end(), isMutant))
        findings.push_back(fmt::format("apart: {} remarks that by the rubric cost nothing, {} "
                                       "mutants that no diagnosis fits",
                                       remarks, unnamed));
    const auto isWhole = [](const auto &record) {
        return isMutant(record) && !record.whole.empty();
    };
    const auto whole = std::count_if(records.begin(), records.end(), isWhole);
    const auto humans = std::count_if(records.begin(), records.end(), [&](const auto &record) {
        return isWhole(record) &&
               std::any_of(record.whole.begin(), record.whole.end(),
                           [](const Judgement &each) { return each.humans > 0; });
    });
    if (whole > 0)
        findings.push_back(fmt::format(
            "mutants after which a person must look at another item: {} of {}", humans, whole));
    return findings;
}

std::string escaped(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
        text.insert(at, "\\");
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// What is wrong, and where that cannot be seen.
std::string mistakeCell(const Patch &patch) {
    return escaped(patch.equivalent.empty()
                       ? patch.what
                       : fmt::format("{} *No difference: {}.*", patch.what, patch.equivalent));
}

std::string diagnosisCell(const PatchRecord &record) {
    if (record.patch.diagnoses.empty())
        return "none fits";
    if (record.whole.empty())
        return "";
    const std::size_t rank = record.whole.front().diagnosisRank;
    return rank == 0 ? "no" : fmt::format("{}", rank);
}

std::string ratio(const std::vector<Judgement> &judgements) {
    const auto right = std::count_if(judgements.begin(), judgements.end(),
                                     [](const Judgement &each) { return each.asExpected; });
    return judgements.empty() ? "" : fmt::format("{}/{}", right, judgements.size());
}

} // namespace

bool PatchRecord::asExpected() const {
    const auto right = [](const Judgement &judgement) {
        return judgement.asExpected;
    };
    return std::all_of(whole.begin(), whole.end(), right) &&
           std::all_of(item.begin(), item.end(), right);
}

bool reachesWanted(const std::vector<PatchRecord> &records) {
    const std::vector<Rate> rates = ratesOf(records);
    return !rates.empty() && std::all_of(rates.begin(), rates.end(),
                                         [](const Rate &rate) { return rate.isReached(); });
}

std::string summarise(const std::vector<PatchRecord> &records) {
    std::string text;
    for (const std::string &finding : findingsOf(records))
        text += finding + "\n";
    return text;
}

std::string markdown(const std::vector<PatchRecord> &records, const std::string &commit) {
    std::string text = fmt::format("Measured at commit `{}`.\n\n", commit);
    for (const std::string &finding : findingsOf(records))
        text += fmt::format("- {}\n", finding);
    const bool mutants = std::any_of(records.begin(), records.end(), isMutant);
    text += mutants ? "\n| mutant | mistake | item | expected | whole | own item | diagnosis |\n"
                      "| --- | --- | --- | --- | --- | --- | --- |\n"
                    : "\n| variant | difference | whole gradings as expected |\n"
                      "| --- | --- | --- |\n";
    for (const PatchRecord &record : records) {
        const Patch &patch = record.patch;
        if (mutants)
            text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", patch.name,
                                mistakeCell(patch), patch.item, patch.costName(),
                                ratio(record.whole), ratio(record.item), diagnosisCell(record));
        else
            text += fmt::format("| {} | {} | {} |\n", patch.name, escaped(patch.what),
                                ratio(record.whole));
    }
    return text;
}

void replaceSection(const std::filesystem::path &file, const std::string &name,
                    const std::string &text) {
    const std::string begin = fmt::format("<!-- {}: begin -->\n", name);
    const std::string end = fmt::format("<!-- {}: end -->\n", name);
    std::string whole = grader::readTextFile(file);
    const std::size_t from = whole.find(begin);
    const std::size_t to = whole.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from)
        throw ExamError(fmt::format("{}: has no section \"{}\"", file.string(), name));
    whole.replace(from + begin.size(), to - from - begin.size(), text);
    grader::writeTextFile(file, whole);
}

} // namespace exam
