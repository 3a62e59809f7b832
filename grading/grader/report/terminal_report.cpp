// SPDX-License-Identifier: MIT
#include "terminal_report.h"

#include <grader/results/safe_text.h>
#include <grader/scoring/points.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "text_layout.h"

namespace grader {

namespace {

constexpr std::size_t kNarrowestReason = 24; ///< below it, reasons go on lines of their own
constexpr std::size_t kMostNotes = 12;
constexpr std::size_t kMostNames = 12;

/// How a verdict is shown: sign in ASCII and Unicode, SGR colour. Told apart without colour too.
struct VerdictLook {
    const char *ascii;
    const char *sign;
    const char *colour;
};

VerdictLook lookOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::Pass:
        return {"+", "✔", "36"};
    case Verdict::Inconclusive:
    case Verdict::Human:
    case Verdict::Infra:
        return {"!", "▲", "33"};
    case Verdict::Missing:
        return {"o", "○", "2"};
    default:
        return {"x", "✖", "1;31"};
    }
}

struct Row {
    std::string item, points, verdict, reason;
    Verdict kind = Verdict::Infra;
};

class TableWriter {
public:
    TableWriter(const SubmissionResult &result, const TerminalStyle &style)
        : m_marked(result.marked), m_style(style) {
        m_rows.push_back({"item", "points", "verdict", "reason", Verdict::Infra});
        for (const ItemResult &item : result.items)
            m_rows.push_back(rowOf(item));
        for (const Row &row : m_rows) {
            m_itemWidth = std::max(m_itemWidth, displayWidth(row.item));
            m_pointsWidth = std::max(m_pointsWidth, displayWidth(row.points));
            m_verdictWidth = std::max(m_verdictWidth, displayWidth(row.verdict));
        }
    }

    std::string write() const {
        std::string text;
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            writeRow(m_rows[i], i == 0, text);
        return text;
    }

private:
    Row rowOf(const ItemResult &item) const {
        const VerdictLook look = lookOf(item.verdict);
        return {safeLine(item.id) + (item.extra ? " (extra)" : ""),
                std::isfinite(item.points)
                    ? fmt::format("{} / {}", formatPoints(item.points), formatPoints(item.max))
                    : fmt::format("- / {}", formatPoints(item.max)),
                fmt::format("{} {}", m_style.unicodeSigns ? look.sign : look.ascii,
                            verdictName(item.verdict)),
                safeLine(item.reason), item.verdict};
    }

    void writeRow(const Row &row, bool isHead, std::string &text) const {
        std::string line = "  " + padRight(row.item, m_itemWidth);
        if (m_marked)
            line += "  " + padLeft(row.points, m_pointsWidth);
        const std::size_t before = displayWidth(line) + 2 + m_verdictWidth + 2;
        const std::string verdict = padRight(row.verdict, m_verdictWidth);
        line += "  " + (m_style.colour && !isHead
                            ? fmt::format("\x1b[{}m{}\x1b[0m", lookOf(row.kind).colour, verdict)
                            : verdict);
        const bool own = m_style.width > 0 && m_style.width < before + kNarrowestReason;
        const std::size_t indent = own ? 6 : before;
        const std::size_t room =
            m_style.width == 0 ? 0 : std::max<std::size_t>(m_style.width, indent + 10) - indent;
        text += line;
        if (own && isHead) {
            text += '\n';
            return;
        }
        text += own ? "\n" + std::string(indent, ' ') : "  ";
        const std::vector<std::string> lines = wrapText(row.reason, room);
        for (std::size_t i = 0; i < lines.size(); ++i)
            text += (i > 0 ? std::string(indent, ' ') : "") + lines[i] + "\n";
    }

    bool m_marked;
    TerminalStyle m_style;
    std::vector<Row> m_rows;
    std::size_t m_itemWidth = 0;
    std::size_t m_pointsWidth = 0;
    std::size_t m_verdictWidth = 0;
};

/// `label` and the text beside it, broken to the width of the terminal.
void writeLabelled(const std::string &label, const std::string &content, const TerminalStyle &style,
                   std::string &text) {
    const std::string head = "  " + label + " ";
    const std::size_t indent = displayWidth(head);
    const std::size_t room =
        style.width == 0 ? 0 : std::max<std::size_t>(style.width, indent + 10) - indent;
    const std::vector<std::string> lines = wrapText(safeLine(content), room);
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += (i == 0 ? head : std::string(indent, ' ')) + lines[i] + "\n";
}

/// The likeliest mistake of each item and the hints that the rubric allows. In English the sentence
/// stands in the reason already.
void writeHints(const SubmissionResult &result, const TerminalStyle &style, std::string &text) {
    std::string hints;
    for (const ItemResult &item : result.items) {
        const Diagnosis *diagnosis =
            item.diagnoses.empty() ? nullptr : findDiagnosis(item.diagnoses.front().id);
        if (diagnosis == nullptr)
            continue;
        const DiagnosisText &told = diagnosis->in(style.language);
        std::string line = style.language == Language::English ? "" : " " + told.sentence;
        for (std::size_t step = 0; step < std::min(result.hintSteps, kHintSteps); ++step)
            line += (step > 0 ? fmt::format(" ({}) ", step + 1) : " ") + told.hints[step];
        if (!line.empty())
            writeLabelled(style.language == Language::Spanish ? "pista:" : "hint:",
                          item.id + ":" + line, style, hints);
    }
    if (!hints.empty())
        text += "\n" + hints;
}

void writeNotes(const SubmissionResult &result, const TerminalStyle &style, std::string &text) {
    std::vector<const Note *> shown;
    for (const Note::Level level : {Note::Level::Human, Note::Level::Odd}) {
        for (const Note &note : result.notes) {
            if (note.level == level)
                shown.push_back(&note);
        }
    }
    if (shown.empty())
        return;
    text += "\n";
    const std::size_t count = std::min(shown.size(), kMostNotes);
    for (std::size_t i = 0; i < count; ++i) {
        const Note &note = *shown[i];
        const std::string label = note.level == Note::Level::Human ? "look:" : "note:";
        writeLabelled(label, note.file.empty() ? note.text : note.file + ": " + note.text, style,
                      text);
    }
    if (shown.size() > count)
        writeLabelled("note:",
                      fmt::format("and {} more; all are in the page and in results.json",
                                  shown.size() - count),
                      style, text);
}

/// `a/b/` if that is the folder that all files are in, empty if there is none. What was ignored,
/// such as macOS's own folder, does not count where anything else is there.
std::string commonFolder(const std::vector<FileUse> &files) {
    const auto counts = [](const FileUse &file) {
        return file.use != "ignored";
    };
    const bool all = std::none_of(files.begin(), files.end(), counts);
    std::optional<std::string> common;
    for (const FileUse &file : files) {
        if (!all && !counts(file))
            continue;
        if (!common)
            common = file.path;
        const auto end =
            std::mismatch(common->begin(), common->end(), file.path.begin(), file.path.end());
        common->erase(end.first, common->end());
    }
    return common ? common->substr(0, common->rfind('/') + 1) : "";
}

void writeNames(const std::string &label, const std::vector<std::string> &names,
                const TerminalStyle &style, std::string &text) {
    if (names.empty())
        return;
    const std::size_t count = std::min(names.size(), kMostNames);
    std::string list = fmt::format("{}", fmt::join(names.begin(), names.begin() + count, ", "));
    if (names.size() > count)
        list += fmt::format(", and {} more", names.size() - count);
    writeLabelled(label, list, style, text);
}

/// `3 match, 1 different_scene`, and what staff should look at, a line each.
void writeFigures(const SubmissionResult &result, const TerminalStyle &style, std::string &text) {
    std::vector<std::pair<FigureVerdict, int>> counts; // in the order in which they occur
    std::vector<const FigureResult *> flagged;
    for (const FigureResult &figure : result.figures) {
        const auto found = std::find_if(counts.begin(), counts.end(), [&](const auto &count) {
            return count.first == figure.verdict;
        });
        if (found == counts.end())
            counts.emplace_back(figure.verdict, 1);
        else
            ++found->second;
        if (figure.flag)
            flagged.push_back(&figure);
    }
    if (counts.empty())
        return;
    std::vector<std::string> parts;
    parts.reserve(counts.size());
    for (const auto &[verdict, count] : counts)
        parts.push_back(fmt::format("{} {}", count, figureVerdictName(verdict)));
    text += "\n";
    writeLabelled("figures:", fmt::format("{}", fmt::join(parts, ", ")), style, text);
    const std::size_t count = std::min(flagged.size(), kMostNotes);
    for (std::size_t i = 0; i < count; ++i)
        writeLabelled("figure:", fmt::format("{}: {}", flagged[i]->path, flagged[i]->message),
                      style, text);
    if (flagged.size() > count)
        writeLabelled("figure:",
                      fmt::format("and {} more; all are in the page and in results.json",
                                  flagged.size() - count),
                      style, text);
}

void writeFiles(const SubmissionResult &result, const TerminalStyle &style, std::string &text) {
    const std::string folder = commonFolder(result.files);
    std::vector<std::string> used;
    std::vector<std::string> ignored;
    for (const FileUse &file : result.files) {
        const bool inside = file.path.compare(0, folder.size(), folder) == 0;
        const std::string name = inside ? file.path.substr(folder.size()) : file.path;
        if (file.use == "ignored")
            ignored.push_back(name + (file.reason.empty() ? "" : " (" + file.reason + ")"));
        else if (file.use == "source" || file.use == "extra" || file.use == "header")
            used.push_back(name);
    }
    if (used.empty() && ignored.empty())
        return;
    text += "\n";
    if (!folder.empty())
        writeLabelled("in:", folder, style, text);
    writeNames("used:", used, style, text);
    writeNames("ignored:", ignored, style, text);
}

} // namespace

std::string sumLine(const SubmissionResult &result) {
    if (!std::isfinite(result.total))
        return "not graded";
    if (result.marked) {
        double earned = 0;
        for (const ItemResult &item : result.items)
            earned += item.points;
        const std::string sum =
            fmt::format("{} of {}", formatPoints(result.total), formatPoints(result.cap));
        // With a point lost beside it, a full sum would look like a mistake.
        return earned > result.cap + 0.005
                   ? fmt::format("{} ({} earned, the cap is {})", sum, formatPoints(earned),
                                 formatPoints(result.cap))
                   : sum;
    }
    const auto right =
        std::count_if(result.items.begin(), result.items.end(),
                      [](const ItemResult &item) { return item.verdict == Verdict::Pass; });
    return fmt::format("{} of {} items right", right, result.items.size());
}

std::string terminalReport(const SubmissionResult &result, const TerminalStyle &style) {
    std::string text = safeLine(result.name);
    if (!result.members.empty())
        text += fmt::format(" ({})", safeLine(fmt::format("{}", fmt::join(result.members, ", "))));
    text += "\n\n" + TableWriter(result, style).write() + "\n";
    const std::string sum = sumLine(result);
    text += style.colour ? fmt::format("  \x1b[1m{}\x1b[0m", sum) : "  " + sum;
    if (hasInfraFailure(result))
        text += ", not final: a part could not be tested";
    else if (needsHuman(result))
        text += ", not final: someone has to look";
    text += "\n";
    writeHints(result, style, text);
    writeNotes(result, style, text);
    writeFigures(result, style, text);
    writeFiles(result, style, text);
    return text;
}

} // namespace grader
