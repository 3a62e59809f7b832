// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>

#include <cstdint>
#include <string>
#include <vector>

namespace support {

/// Text that tries to do something where it is shown: markup, scripts, terminal escapes (C0, C1),
/// direction overrides, bytes that are no UTF-8, formulas, JSON and format strings.
inline const std::vector<std::string> &hostileStrings() {
    using namespace std::string_literals;
    static const std::vector<std::string> strings = {
        "<script>alert(1)</script>",
        "<img src=x onerror=alert(1)>",
        "\"><svg onload=alert(1)>",
        "' onmouseover='alert(1)",
        "</style><script>alert(1)</script>",
        "</title><script>alert(1)</script>",
        "<!-- --><iframe src=javascript:alert(1)>",
        "&lt;script&gt;",
        "javascript:alert(1)",
        "<a href=\"https://example.org\">x</a>",
        "<meta http-equiv=refresh content=0>",
        "<base href=//example.org>",
        "\x1b[2J\x1b[H",
        "\x1b]0;title\x07",
        "\x1b]8;;https://example.org\x1b\\x\x1b]8;;\x1b\\",
        "\xc2\x9b"s + "31m red",
        "\x9b"s + "31m red",
        "\r100 of 100",
        "a\nb",
        "a\tb",
        "a\bb\x7f",
        "nul\0byte"s,
        "\xe2\x80\xae"s + "gnp.exe",
        "\xe2\x81\xa6"s + "isolate",
        "\xe2\x80\x8b"s + "zero width",
        "\xe2\x80\xa8"s + "line separator",
        "\xf3\xa0\x81\x81"s + "tag",
        "\xff\xfe",
        "\xc3",
        "\xed\xa0\x80",
        "\xf4\x90\x80\x80",
        "=cmd|' /C calc'!A0",
        "+1+1",
        "@SUM(1)",
        "{\"total\": 100}",
        "\", \"total\": 100, \"x\": \"",
        "\\u001b[31m",
        "%s%n%p",
        "{} {0}",
        "$(id) `id`",
        "../../etc/passwd",
        "-rf",
        "Muñoz_á 田中 عرب 🎨",
    };
    return strings;
}

inline grader::CheckResult sampleCheck(const std::string &id, grader::Verdict verdict) {
    grader::CheckResult check;
    check.id = id;
    check.verdict = verdict;
    check.message = "The density differs by 50 %.";
    check.score = verdict == grader::Verdict::Pass ? 1 : 0;
    return check;
}

/// A hand-in with an item of every look, a note of every level and files of three uses.
inline grader::SubmissionResult sampleResult() {
    using grader::Verdict;
    grader::SubmissionResult result;
    result.name = "p2_123456_654321";
    result.members = {"123456", "654321"};
    result.total = 72.5;
    result.cap = 100;
    result.sandbox = "S3";
    result.seed = "0000000000000000000000000000002a";
    const auto add = [&](const char *id, double points, double max, bool extra, Verdict verdict,
                         const char *reason) {
        grader::ItemResult item;
        item.id = id;
        item.title = std::string("Title of ") + id;
        item.points = points;
        item.max = max;
        item.extra = extra;
        item.verdict = verdict;
        item.reason = reason;
        item.checks = {sampleCheck(std::string(id) + ".density", verdict)};
        result.items.push_back(item);
    };
    add("warp.triangle", 10, 10, false, Verdict::Pass, "Right in everything that was tested.");
    add("warp.disk", 0, 10, true, Verdict::Missing, "warp.cpp was not handed in.");
    add("direct_ems", 2.5, 20, false, Verdict::Fail,
        "The mean radiance is 31 % low. Is the probability of the chosen light divided by?");
    add("environment_light", 10, 10, false, Verdict::Inconclusive,
        "Cannot be told, and so costs nothing: too few samples.");
    result.items[2].checks[0].effect = 0.31;
    result.items[2].checks[0].p = 1e-12;
    result.items[2].checks[0].diagnosis = "Divide by the probability.";
    result.notes = {{grader::Note::Level::Info, "", "Nothing special."},
                    {grader::Note::Level::Odd, "src/área.cpp", "looks like area.cpp"}};
    result.files = {{"src/warp.cpp", "source", "replaces the base's"},
                    {"README.txt", "readme", "read"},
                    {"src/main_old.cpp", "ignored", "a copy of main.cpp"}};
    grader::FigureResult figure;
    figure.path = "figures/cbox_ems_16.exr";
    figure.verdict = grader::FigureVerdict::DifferentScene;
    figure.flag = true;
    figure.scene = "cbox_ems";
    figure.samples = 16;
    figure.error = -0.25;
    figure.noise = 1.5;
    figure.p = 1e-9;
    figure.message = "It shows table_ems, not cbox_ems.";
    grader::FigureResult missing;
    missing.path = "serapis_ems_1.exr";
    missing.verdict = grader::FigureVerdict::Missing;
    missing.message = "The handout asks for it.";
    result.figures = {figure, missing};
    result.timing.compile = 3.5;
    result.timing.total = 12;
    return result;
}

/// The same with a map of points of one check: all in the lowest of the triangle's cells.
inline grader::SubmissionResult resultWithMap() {
    grader::SubmissionResult result = sampleResult();
    grader::PointMap map{"triangle", 0, 2048, std::vector<std::uint32_t>(1024, 0)};
    map.counts[0] = 2000;
    result.items[2].checks[0].map = map;
    return result;
}

/// The same as sampleResult() with `text` in every place that a hand-in has a say in.
inline grader::SubmissionResult resultWith(const std::string &text) {
    grader::SubmissionResult result = sampleResult();
    result.name = text;
    result.members = {text};
    for (grader::ItemResult &item : result.items) {
        item.reason = text;
        for (grader::CheckResult &check : item.checks) {
            check.message = text;
            check.diagnosis = text;
            check.variant = text;
        }
    }
    result.notes = {{grader::Note::Level::Human, text, text}};
    result.files = {{text, "source", text}, {text, "ignored", text}};
    for (grader::FigureResult &figure : result.figures) {
        figure.path = text;
        figure.scene = text;
        figure.message = text;
    }
    return result;
}

} // namespace support
