// SPDX-License-Identifier: MIT
#include "results_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "safe_text.h"

namespace grader {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 2;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json guessesJson(const std::vector<Guess> &guesses) {
    Json list = Json::array();
    for (const Guess &guess : guesses)
        list.push_back({{"id", guess.id}, {"fit", number(guess.fit)}});
    return list;
}

Json mapJson(const std::optional<PointMap> &map) {
    if (!map)
        return nullptr;
    return {{"warp", map->warp},
            {"parameter", number(map->parameter)},
            {"points", map->points},
            {"counts", map->counts}};
}

Json checkJson(const CheckResult &check) {
    return {{"id", check.id},
            {"verdict", verdictName(check.verdict)},
            {"severity", severityName(check.severity)},
            {"score", number(check.score)},
            {"effect", number(check.effect)},
            {"mde", number(check.mde)},
            {"floor", number(check.floor)},
            {"p", number(check.p)},
            {"message", check.message},
            {"diagnosis", check.diagnosis},
            {"diagnoses", guessesJson(check.diagnoses)},
            {"map", mapJson(check.map)},
            {"variant", check.variant}};
}

Json itemJson(const ItemResult &item, bool marked) {
    Json checks = Json::array();
    for (const CheckResult &check : item.checks)
        checks.push_back(checkJson(check));
    return {{"id", item.id},
            {"title", item.title},
            {"points", number(marked ? item.points : kNoNumber)},
            {"max", number(item.max)},
            {"extra", item.extra},
            {"verdict", verdictName(item.verdict)},
            {"reason", item.reason},
            {"diagnoses", guessesJson(item.diagnoses)},
            {"checks", std::move(checks)}};
}

Json figureJson(const FigureResult &figure) {
    return {{"path", figure.path},
            {"verdict", figureVerdictName(figure.verdict)},
            {"flag", figure.flag},
            {"scene", figure.scene},
            {"spp", figure.samples > 0 ? Json(figure.samples) : Json(nullptr)},
            {"error", number(figure.error)},
            {"mde", number(figure.mde)},
            {"noise", number(figure.noise)},
            {"p", number(figure.p)},
            {"message", figure.message}};
}

Json timesJson(const Timing &timing) {
    return {{"ingest", number(timing.ingest)}, {"compile", number(timing.compile)},
            {"link", number(timing.link)},     {"sample", number(timing.sample)},
            {"judge", number(timing.judge)},   {"figures", number(timing.figures)},
            {"total", number(timing.total)}};
}

Json submissionJson(const SubmissionResult &result) {
    Json items = Json::array();
    for (const ItemResult &item : result.items)
        items.push_back(itemJson(item, result.marked));
    Json notes = Json::array();
    for (const Note &note : result.notes)
        notes.push_back(
            {{"level", levelName(note.level)}, {"file", note.file}, {"text", note.text}});
    Json files = Json::array();
    for (const FileUse &file : result.files)
        files.push_back({{"path", file.path}, {"use", file.use}, {"reason", file.reason}});
    Json figures = Json::array();
    for (const FigureResult &figure : result.figures)
        figures.push_back(figureJson(figure));
    return {{"name", result.name},
            {"members", result.members},
            {"total", number(result.marked ? result.total : kNoNumber)},
            {"cap", number(result.cap)},
            {"sandbox", result.sandbox},
            {"seed", result.seed},
            {"final", !needsHuman(result) && !hasInfraFailure(result)},
            {"items", std::move(items)},
            {"notes", std::move(notes)},
            {"files", std::move(files)},
            {"figures", std::move(figures)},
            {"times", timesJson(result.timing)}};
}

} // namespace

std::string resultsJson(const RunResult &run) {
    Json submissions = Json::array();
    for (const SubmissionResult &result : run.submissions)
        submissions.push_back(submissionJson(result));
    const Provenance &from = run.provenance;
    const Json document = {{"schema", kSchema},
                           {"tool", {{"name", "norigrade"}, {"version", from.toolVersion}}},
                           {"rubric", {{"id", from.rubricId}, {"sha256", from.rubricDigest}}},
                           {"base", {{"sha256", from.baseDigest}}},
                           {"compiler", from.compiler},
                           {"submissions", std::move(submissions)}};
    // `replace`: names and messages come from hand-ins and may not be UTF-8.
    return escapeInvisible(document.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

} // namespace grader
