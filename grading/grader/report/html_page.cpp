// SPDX-License-Identifier: MIT
#include "html_page.h"

#include <grader/scoring/points.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "html.h"
#include "page_style.h"
#include "point_maps.h"
#include "terminal_report.h"

namespace grader {

namespace {

struct Look {
    const char *style;
    const char *sign;
};

Look lookOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::Pass:
        return {"pass", "✔"};
    case Verdict::Inconclusive:
    case Verdict::Human:
    case Verdict::Infra:
        return {"look", "▲"};
    case Verdict::Missing:
        return {"none", "○"};
    default:
        return {"fail", "✖"};
    }
}

std::string verdictCell(Verdict verdict) {
    const Look look = lookOf(verdict);
    return fmt::format(R"(<td class="verdict {}">{} {}</td>)", look.style, look.sign,
                       verdictName(verdict));
}

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : std::string("–");
}

std::string points(const ItemResult &item) {
    return fmt::format("{} / {}", std::isfinite(item.points) ? formatPoints(item.points) : "–",
                       formatPoints(item.max));
}

/// Text of a hand-in, set apart so that its direction of writing stays its own.
std::string isolated(std::string_view text) {
    return fmt::format("<bdi>{}</bdi>", escapeHtml(text));
}

std::string itemTable(const SubmissionResult &result) {
    std::string html =
        "<div class=\"scroll stack\"><table>\n<thead><tr><th scope=\"col\">Item</th>";
    if (result.marked)
        html += R"(<th scope="col" class="number">Points</th>)";
    html += "<th scope=\"col\">Verdict</th><th scope=\"col\">Reason</th></tr></thead>\n<tbody>\n";
    for (const ItemResult &item : result.items) {
        html += fmt::format("<tr><th scope=\"row\">{}{}</th>", escapeHtml(item.title),
                            item.extra ? " (extra)" : "");
        if (result.marked)
            html += fmt::format("<td class=\"number\">{}</td>", points(item));
        html += fmt::format("{}<td class=\"reason\">{}</td></tr>\n", verdictCell(item.verdict),
                            isolated(item.reason));
    }
    return html + "</tbody>\n</table></div>\n";
}

/// `Hint 1`, told one by one, so that a student can stop at the first that helps.
std::string hintLadder(const DiagnosisText &text, std::size_t steps, Language language) {
    std::string html;
    for (std::size_t step = 0; step < std::min(steps, kHintSteps); ++step)
        html += fmt::format("<details><summary>{} {}</summary><p>{}</p></details>\n",
                            language == Language::Spanish ? "Pista" : "Hint", step + 1,
                            escapeHtml(text.hints[step]));
    return html;
}

/// Likely mistakes of all items, in both languages; radio buttons before it choose one.
std::string diagnosisSection(const SubmissionResult &result, Language shown) {
    std::string body;
    for (const ItemResult &item : result.items) {
        if (item.diagnoses.empty())
            continue;
        body += fmt::format("<h3>{}</h3>\n", escapeHtml(item.title));
        for (const Guess &guess : item.diagnoses) {
            const Diagnosis *diagnosis = findDiagnosis(guess.id);
            if (diagnosis == nullptr)
                continue;
            for (const Language language : kLanguages) {
                const DiagnosisText &text = diagnosis->in(language);
                body += fmt::format("<div lang=\"{}\"><p>{}</p>\n{}</div>\n",
                                    languageCode(language), escapeHtml(text.sentence),
                                    hintLadder(text, result.hintSteps, language));
            }
        }
    }
    if (body.empty())
        return body;
    std::string html =
        "<section>\n<h2>What it may be · <span lang=\"es\">Qué puede ser</span></h2>\n";
    for (const Language language : kLanguages)
        html += fmt::format("<input type=\"radio\" name=\"lang\" id=\"lang-{0}\"{1}>"
                            "<label for=\"lang-{0}\" lang=\"{0}\">{2}</label>\n",
                            languageCode(language), language == shown ? " checked" : "",
                            language == Language::Spanish ? "Español" : "English");
    return html + "<div class=\"both\">\n" + body + "</div>\n</section>\n";
}

std::string checkRow(const CheckResult &check) {
    std::string html =
        fmt::format("<tr><th scope=\"row\">{}</th>{}<td>{}</td>", escapeHtml(check.id),
                    verdictCell(check.verdict), severityName(check.severity));
    for (const double value : {check.effect, check.mde, check.p})
        html += fmt::format("<td class=\"number\">{}</td>", number(value));
    html += fmt::format("<td class=\"message\">{}", isolated(check.message));
    if (!check.diagnosis.empty())
        html += fmt::format("<br><strong>{}</strong>", isolated(check.diagnosis));
    if (!check.variant.empty())
        html += fmt::format("<br><small>tested on: {}</small>", escapeHtml(check.variant));
    return html + "</td></tr>\n";
}

std::string checkTables(const SubmissionResult &result) {
    std::string html;
    for (const ItemResult &item : result.items) {
        if (item.checks.empty())
            continue;
        const Look look = lookOf(item.verdict);
        html += fmt::format("<details{}><summary><span class=\"{}\">{}</span> {}</summary>\n"
                            "<div class=\"scroll stack\"><table>\n<thead><tr>",
                            item.verdict == Verdict::Pass ? "" : " open", look.style, look.sign,
                            escapeHtml(item.title));
        for (const char *head :
             {"Check", "Verdict", "Severity", "Effect", "Would find", "p", "What was found"})
            html += fmt::format("<th scope=\"col\">{}</th>", head);
        html += "</tr></thead>\n<tbody>\n";
        for (const CheckResult &check : item.checks)
            html += checkRow(check);
        html += "</tbody>\n</table></div>\n" + pointMaps(item) + "</details>\n";
    }
    return html.empty() ? html : "<h2>Checks</h2>\n" + html;
}

std::string noteList(const SubmissionResult &result) {
    if (result.notes.empty())
        return {};
    std::string html = "<h2>Notes</h2>\n<ul>\n";
    for (const Note &note : result.notes) {
        html += "<li>";
        if (note.level == Note::Level::Human)
            html += "<strong class=\"look\">▲ someone has to look:</strong> ";
        if (!note.file.empty())
            html += isolated(note.file) + ": ";
        html += isolated(note.text) + "</li>\n";
    }
    return html + "</ul>\n";
}

Look lookOf(const FigureResult &figure) {
    if (figure.flag)
        return {"look", "▲"};
    return figure.verdict == FigureVerdict::Match ? Look{"pass", "✔"} : Look{"none", "○"};
}

std::string figureTable(const SubmissionResult &result) {
    if (result.figures.empty())
        return {};
    std::string html =
        "<h2>Figures</h2>\n<p>Compared with what the hand-in's own code renders. This costs no "
        "points; ▲ is for staff to look at.</p>\n<div class=\"scroll\"><table>\n<thead><tr>"
        "<th scope=\"col\">Figure</th><th scope=\"col\">Verdict</th>"
        "<th scope=\"col\" class=\"number\">Mean off</th>"
        "<th scope=\"col\" class=\"number\">Noise ratio</th>"
        "<th scope=\"col\" class=\"number\">p</th>"
        "<th scope=\"col\">What was found</th></tr></thead>\n<tbody>\n";
    for (const FigureResult &figure : result.figures) {
        const Look look = lookOf(figure);
        std::string verdict = figureVerdictName(figure.verdict);
        std::replace(verdict.begin(), verdict.end(), '_', ' ');
        html += fmt::format(R"(<tr><th scope="row">{}</th><td class="verdict {}">{} {}</td>)",
                            isolated(figure.path), look.style, look.sign, verdict);
        html +=
            fmt::format("<td class=\"number\">{}</td>",
                        std::isfinite(figure.error) ? fmt::format("{:+.2g} %", 100 * figure.error)
                                                    : std::string("–"));
        for (const double value : {figure.noise, figure.p})
            html += fmt::format("<td class=\"number\">{}</td>", number(value));
        html += fmt::format("<td class=\"reason\">{}</td></tr>\n", isolated(figure.message));
    }
    return html + "</tbody>\n</table></div>\n";
}

std::string fileTable(const SubmissionResult &result) {
    if (result.files.empty())
        return {};
    std::string html = "<h2>Files</h2>\n<div class=\"scroll\"><table>\n<thead><tr>"
                       "<th scope=\"col\">File</th><th scope=\"col\">Used as</th>"
                       "<th scope=\"col\">Why</th></tr></thead>\n<tbody>\n";
    for (const FileUse &file : result.files)
        html += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"reason\">{}</td></tr>\n",
            isolated(file.path), escapeHtml(file.use), isolated(file.reason));
    return html + "</tbody>\n</table></div>\n";
}

std::string provenanceList(const SubmissionResult &result, const Provenance &from) {
    std::string html = "<h2>How this was tested</h2>\n<dl>\n";
    const auto entry = [&](const char *name, const std::string &value) {
        if (!value.empty())
            html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escapeHtml(value));
    };
    entry("Grader", "norigrade " + from.toolVersion);
    entry("Rubric", from.rubricId + " (" + from.rubricDigest + ")");
    entry("Base code", from.baseDigest);
    entry("Compiler", from.compiler);
    entry("Sandbox", result.sandbox);
    entry("Seed", result.seed);
    const Timing &time = result.timing;
    entry("Time",
          fmt::format("{:.1f} s (compile {:.1f}, link {:.1f}, run {:.1f}, judge {:.1f}, "
                      "figures {:.1f})",
                      time.total, time.compile, time.link, time.sample, time.judge, time.figures));
    return html + "</dl>\n";
}

} // namespace

std::string htmlPage(const SubmissionResult &result, const Provenance &provenance,
                     Language language) {
    std::string html =
        fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                    "style-src '{}'; "
                    "base-uri 'none'; form-action 'none'\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                    "<title>{} – {}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
                    contentHash(kPageStyle), escapeHtml(result.name), sumLine(result), kPageStyle);
    html += fmt::format("<h1>{}</h1>\n", isolated(result.name));
    if (!result.members.empty())
        html += fmt::format("<p>{}</p>\n",
                            isolated(fmt::format("{}", fmt::join(result.members, ", "))));
    html += fmt::format("<p class=\"total\">{}</p>\n", sumLine(result));
    if (hasInfraFailure(result))
        html += "<p>Not final: a part could not be tested, through no fault of the hand-in.</p>\n";
    if (needsHuman(result))
        html += "<p>Not final: someone has to look.</p>\n";
    html += itemTable(result) + diagnosisSection(result, language) + checkTables(result) +
            noteList(result) + figureTable(result) + fileTable(result) +
            provenanceList(result, provenance);
    return html + "</main>\n</body>\n</html>\n";
}

std::string pageName(const std::string &submissionName, std::size_t index) {
    std::string name;
    for (const char c : submissionName) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        if (plain)
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    name.resize(std::min<std::size_t>(name.size(), 80));
    if (name.empty())
        name = "submission";
    return index > 0 ? fmt::format("{}-{}.html", name, index + 1) : name + ".html";
}

} // namespace grader
