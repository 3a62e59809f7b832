// SPDX-License-Identifier: MIT
#include <grader/build/base.h>
#include <support/schema_checker.h>
#include <support/work_folder.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <png.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <exam/command.h>

namespace {

using Json = nlohmann::json;

const std::string kRenderer = std::string(NORI_SOURCE_DIR) + "/renderer/src/warp.cpp";

#ifdef NORI_GUI
std::string textChunk(const std::string &file, const std::string &key) {
    std::FILE *const stream = std::fopen(file.c_str(), "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, stream);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_textp texts = nullptr;
    const int count = png_get_text(png, info, &texts, nullptr);
    std::string found;
    for (int i = 0; i < count; ++i) {
        if (texts[i].key == key)
            found.assign(texts[i].text, texts[i].itxt_length);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(stream);
    return found;
}
#endif

/// The program itself.
class Warptest : public testing::Test {
protected:
    exam::Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), WARPTEST);
        return exam::runCommand(arguments, m_folder.path());
    }

    std::string path(const std::string &name) const { return (m_folder.path() / name).string(); }

    std::string read(const std::string &name) const {
        std::ifstream stream(m_folder.path() / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }

    static std::string textOf(const std::string &file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }

    support::WorkFolder m_folder;
};

TEST_F(Warptest, ExitCodeSaysWhetherAWarpIsRight) {
    EXPECT_EQ(run({"triangle"}).exitCode, 0);
    EXPECT_EQ(run({"triangle, wrong: missing_sqrt", "--mistakes"}).exitCode, 1);
    const exam::Outcome few = run({"triangle", "--samples", "1024"});
    EXPECT_EQ(few.exitCode, 3) << few.output;
    EXPECT_NE(few.output.find("cannot tell"), std::string::npos) << few.output;
}

TEST_F(Warptest, RefusesWhatWouldDoNothing) {
    for (const std::vector<std::string> &line :
         std::vector<std::vector<std::string>>{{"--json"},
                                               {"triangle", "--rows", "8"},
                                               {"triangle", "--points", "grid"},
                                               {"triangle", "--theme", "light"},
                                               {"triangle", "--all"},
                                               {"--html", "a.html"},
                                               {"triangle", "--json", "--dump", "m"},
                                               {"cube"},
                                               {"triangle", "--alpha", "1"}}) {
        const exam::Outcome outcome = run(line);
        EXPECT_EQ(outcome.exitCode, 2) << line.back() << outcome.output;
        EXPECT_FALSE(outcome.errors.empty()) << line.back();
    }
}

TEST_F(Warptest, JsonIsAsPublished) {
    const auto schema = support::SchemaChecker::ofFile("warptest/app/warptest.schema.json");
    const exam::Outcome outcome = run({"beckmann", "0.3", "--json", "--rows", "12", "--seeds", "3",
                                       "--samples", "65536", "--alpha", "1e-3", "--seed", "7"});
    const Json document = Json::parse(outcome.output);
    EXPECT_EQ(schema.check(document), "");
    const Json &test = document["tests"][0];
    EXPECT_EQ(test["maps"]["observed"].size(), 144U);
    EXPECT_EQ(test["seed_p_values"].size(), 3U);
    EXPECT_EQ(test["alpha"], 1e-3);
    EXPECT_EQ(test["parameter"], 0.3);
    EXPECT_EQ(run({"beckmann", "0.3", "--json", "--rows", "12", "--seeds", "3", "--samples",
                   "65536", "--alpha", "1e-3", "--seed", "7"})
                  .output,
              outcome.output);
    const exam::Outcome stub = run({"triangle, not implemented", "--mistakes", "--json"});
    const Json thrown = Json::parse(stub.output);
    EXPECT_EQ(schema.check(thrown), "");
    EXPECT_EQ(thrown["tests"][0]["summary"], "not implemented");
    Json twin = document;
    twin["tests"][0]["verdict"] = "accepted";
    EXPECT_NE(schema.check(twin), "");
}

TEST_F(Warptest, DumpsTheCountsOfTheMaps) {
    const Json json = Json::parse(run({"disk", "--dump", "json", "--rows", "6"}).output);
    double expected = 0.0;
    for (const double count : json[0]["expected"])
        expected += count;
    EXPECT_NEAR(expected, json[0]["points"], 0.01 * expected);
    const std::string csv = run({"disk", "--dump", "csv", "--rows", "6"}).output;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 37);
    const std::string matlab = run({"disk", "--dump", "m", "--rows", "6"}).output;
    for (const char *name : {"obsFrequencies = [", "expFrequencies = [", "sampleCount = 262144"})
        EXPECT_NE(matlab.find(name), std::string::npos) << matlab;
}

TEST_F(Warptest, PageIsWholeWithoutScriptsAndNetwork) {
    const exam::Outcome outcome =
        run({"triangle, wrong: missing_sqrt", "--mistakes", "--seeds", "2", "--samples", "65536",
             "--points", "stratified", "--json", "--html", path("page.html")});
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    const std::string page = read("page.html");
    for (const char *part :
         {"default-src 'none'", "style-src 'sha256-", "✖ fail", "Map of the residuals",
          "Nearest known mistakes", "The square root is missing", "Samples: stratified",
          "mean of x²", "farthest off", "Histogram of the residuals", "Counts along y",
          "Sorted p-values of all seeds", "χ²", "--points stratified", "prefers-color-scheme: dark",
          "@media print"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    // nothing runs, nothing is fetched, and no style but the one that the policy names
    for (const char *part : {"<script>", "src=", " style=", "onload", "url(", "@import"})
        EXPECT_EQ(page.find(part), std::string::npos) << part;
    for (std::size_t at = 0; (at = page.find("http", at)) != std::string::npos; ++at)
        EXPECT_TRUE(page.compare(at, 18, "http://www.w3.org/") == 0 ||
                    page.compare(at, 10, "http-equiv") == 0)
            << page.substr(at, 60);
    const std::string mark = "id=\"warptest\">";
    const std::size_t data = page.find(mark) + mark.size();
    EXPECT_EQ(Json::parse(page.substr(data, page.find("</script>", data) - data)),
              Json::parse(outcome.output));
    std::set<std::string> ids;
    for (const char *quote : {" id=\"", " id='"}) {
        for (std::size_t at = 0; (at = page.find(quote, at)) != std::string::npos; at += 5) {
            const std::string id = page.substr(at + 5, page.find(quote[4], at + 5) - at - 5);
            EXPECT_TRUE(ids.insert(id).second) << id << " stands twice";
        }
    }
}

TEST_F(Warptest, TestsAStudentsFileInTheBox) {
    m_folder.write("right.cpp", textOf(kRenderer));
    const exam::Outcome right = run({"disk", "--against", path("right.cpp"), "--json"});
    EXPECT_EQ(right.exitCode, 0) << right.output << right.errors;
    Json document = Json::parse(right.output);
    EXPECT_EQ(document["tests"][0]["from"], "right.cpp");
    // the same numbers as when nothing is between: only the name of whose code it is differs
    Json ours = Json::parse(run({"disk", "--json"}).output);
    document["tests"][0].erase("from");
    ours["tests"][0].erase("from");
    EXPECT_EQ(document, ours);

    const exam::Outcome wrong =
        run({"triangle", "--against",
             std::string(NORI_SOURCE_DIR) + "/tests/submissions/wrong/triangle_without_sqrt"});
    EXPECT_EQ(wrong.exitCode, 1) << wrong.output << wrong.errors;
    EXPECT_NE(wrong.output.find("square root"), std::string::npos) << wrong.output;
}

TEST_F(Warptest, ShowsWhereAFileDoesNotCompile) {
    m_folder.write("mine.cpp", "#include <nori/warp.h>\nint x = y;\n");
    const exam::Outcome outcome = run({"disk", "--against", path("mine.cpp")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.errors.find("mine.cpp:2:9: error: 'y' was not declared"), std::string::npos)
        << outcome.errors;
    EXPECT_EQ(run({"disk", "--against", path("nothing.cpp")}).exitCode, 2);
    std::filesystem::create_directory(m_folder.path() / "empty");
    const exam::Outcome empty = run({"disk", "--against", path("empty")});
    EXPECT_NE(empty.errors.find("there is no warp.cpp in it"), std::string::npos) << empty.errors;
}

TEST_F(Warptest, SaysWhatIsNotImplemented) {
    m_folder.write("warp.cpp", grader::starterBase().units.at("warp.cpp"));
    const exam::Outcome outcome = run({"triangle", "--against", path("warp.cpp")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.output.find("not implemented"), std::string::npos)
        << outcome.output << outcome.errors;

    // the base's square is there; the tent is neither there nor asked for
    const exam::Outcome all = run({"--all", "--against", path("warp.cpp")});
    EXPECT_EQ(all.exitCode, 1);
    EXPECT_NE(all.output.find("1 of 11 tests pass; not disk of warp.cpp, triangle of warp.cpp"),
              std::string::npos)
        << all.output;
    EXPECT_EQ(all.output.find("tent"), std::string::npos) << all.output;
    EXPECT_NE(all.errors.find("tent of warp.cpp: not implemented, and the handout does not ask"),
              std::string::npos)
        << all.errors;
}

#ifdef NORI_GUI
TEST_F(Warptest, PicturesHoldTheDataOfTheCommandLine) {
    const exam::Outcome outcome = run({"disk", "--json", "--evidence", path("figures")});
    EXPECT_EQ(read("figures/UniformDisk.json"), outcome.output);
    EXPECT_EQ(textChunk(path("figures/UniformDisk.png"), "warptest"), outcome.output);
}
#endif

} // namespace
