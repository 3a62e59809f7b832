// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <renderer/app/nori_program.h>

namespace fs = std::filesystem;
using nori::test::Outcome;
using nori::test::Program;

namespace {

/// A lit triangle: 2 x 2 blocks, the last ones cut.
constexpr char kScene[] = R"(<scene>
  <integrator type="direct_ems"/>
  <camera type="perspective"><integer name="width" value="40"/><integer name="height" value="36"/></camera>
  <sampler type="independent"><integer name="sampleCount" value="3"/><integer name="seed" value="5"/></sampler>
  <emitter type="pointlight"><point name="position" value="0 0 -1"/><color name="radiance" value="9 6 3"/></emitter>
  <emitter type="environment"><color name="radiance" value="1 2 3"/></emitter>
  <mesh type="obj"><string name="filename" value="meshes/triangle.obj"/></mesh>
</scene>)";
constexpr char kTriangle[] = "v -1 -1 5\nv 1 -1 5\nv 0 1 5\nf 1 3 2\n";
constexpr char kBlackScene[] = R"(<scene><integrator type="direct_ems"/><camera type="perspective">
  <integer name="width" value="64"/><integer name="height" value="64"/></camera></scene>)";

struct Exr {
    std::map<std::string, std::string> attributes;
    std::map<std::string, std::vector<float>> channels;
};

Exr loadExr(const fs::path &path) {
    Imf::InputFile file(path.c_str());
    Exr exr;
    for (auto it = file.header().begin(); it != file.header().end(); ++it) {
        if (const auto *text = dynamic_cast<const Imf::StringAttribute *>(&it.attribute()))
            exr.attributes[it.name()] = text->value();
    }
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x) + 1;
    const auto height = static_cast<std::size_t>(window.max.y) + 1;
    Imf::FrameBuffer buffer;
    for (auto it = file.header().channels().begin(); it != file.header().channels().end(); ++it) {
        std::vector<float> &plane = exr.channels[it.name()];
        plane.resize(width * height);
        buffer.insert(it.name(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char *>(plane.data()),
                                            sizeof(float), sizeof(float) * width));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return exr;
}

/// A folder with scenes in it, removed at the end.
class Workplace {
public:
    Workplace() {
        std::string pattern = (fs::temp_directory_path() / "nori_cli_XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error("mkdtemp() failed");
        m_folder = pattern;
        fs::create_directories(m_folder / "scenes/meshes");
        write("scenes/small.xml", kScene);
        write("scenes/meshes/triangle.obj", kTriangle);
        write("black.xml", kBlackScene);
    }

    ~Workplace() {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
    }

    Workplace(const Workplace &) = delete;
    Workplace &operator=(const Workplace &) = delete;
    Workplace(Workplace &&) = delete;
    Workplace &operator=(Workplace &&) = delete;

    fs::path path(const std::string &name) const { return m_folder / name; }

    void write(const std::string &name, const std::string &text) const {
        std::ofstream(path(name)) << text;
    }

    Outcome run(const std::vector<std::string> &arguments,
                rlim_t largestFile = RLIM_INFINITY) const {
        return Program(m_folder, arguments, largestFile).finish();
    }

    /// Names in a folder.
    std::set<std::string> files(const std::string &folder) const {
        std::set<std::string> names;
        for (const auto &entry : fs::directory_iterator(path(folder)))
            names.insert(entry.path().filename().string());
        return names;
    }

private:
    fs::path m_folder;
};

class Nori : public testing::Test {
protected:
    fs::path path(const std::string &name) const { return m_workplace.path(name); }

    void write(const std::string &name, const std::string &text) const {
        m_workplace.write(name, text);
    }

    std::set<std::string> files(const std::string &folder) const {
        return m_workplace.files(folder);
    }

    /// Runs the program to its end. \return  its exit code; texts are in output() and errors()
    int run(const std::vector<std::string> &arguments, rlim_t largestFile = RLIM_INFINITY) {
        m_outcome = m_workplace.run(arguments, largestFile);
        return m_outcome.code;
    }

    const std::string &output() const { return m_outcome.output; }

    const std::string &errors() const { return m_outcome.errors; }

private:
    Workplace m_workplace;
    Outcome m_outcome;
};

TEST_F(Nori, WritesBesideTheSceneWithTheFactsInTheHeader) {
    ASSERT_EQ(run({"scenes/small.xml"}), 0) << errors();
    EXPECT_EQ(errors(), "");
    EXPECT_NE(output().find("scenes/small_3.exr"), std::string::npos) << output();
    EXPECT_EQ(files("scenes"),
              (std::set<std::string>{"meshes", "small.xml", "small_3.exr", "small_3.png"}));
    const Exr exr = loadExr(path("scenes/small_3.exr"));
    EXPECT_EQ(exr.attributes.at("spp"), "3");
    EXPECT_EQ(exr.attributes.at("seed"), "5");
    EXPECT_NE(exr.attributes.at("integrator"), "");
    EXPECT_EQ(exr.attributes.at("version").find("nori "), 0u);
    EXPECT_GE(std::stod(exr.attributes.at("renderSeconds")), 0.0);
    EXPECT_EQ(exr.attributes.at("partial"), "no");
    EXPECT_EQ(exr.channels.size(), 3u);
}

TEST_F(Nori, TakesOptionsInAnyOrderAndInAllDialects) {
    ASSERT_EQ(run({"-b", "--threads", "2", "scenes/small.xml", "--nogui", "--no-gui", "--quiet"}),
              0);
    EXPECT_EQ(output() + errors(), "");
    ASSERT_EQ(run({"--spp=2", "scenes/small.xml", "-t", "1"}), 0);
    EXPECT_TRUE(fs::exists(path("scenes/small_2.exr")));
    ASSERT_EQ(run({"scenes/small.xml", "--output", "here"}), 0);
    ASSERT_EQ(run({"scenes/small.xml", "--output", "there.exr"}), 0);
    EXPECT_EQ(files("."), (std::set<std::string>{"black.xml", "here.exr", "here.png", "scenes",
                                                 "there.exr", "there.png"}));
}

TEST_F(Nori, RendersTheSameBitsWithAnyNumberOfThreads) {
    ASSERT_EQ(run({"scenes/small.xml", "-t", "1", "--moments", "--output", "one"}), 0);
    ASSERT_EQ(run({"scenes/small.xml", "-t", "3", "--moments", "--output", "three"}), 0);
    const Exr one = loadExr(path("one.exr"));
    EXPECT_EQ(one.channels, loadExr(path("three.exr")).channels);
    for (const char *layer : {"count.Y", "mean.R", "variance.G", "third.B"})
        EXPECT_EQ(one.channels.count(layer), 1u) << layer;
    EXPECT_EQ(one.channels.at("count.Y"), std::vector<float>(std::size_t{40} * 36, 3.0f));
}

TEST_F(Nori, DrawsOtherSamplesWithAnotherSeedOnly) {
    const auto render = [this](const std::vector<std::string> &more) {
        std::vector<std::string> arguments{"scenes/small.xml", "--output", "out"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(run(arguments), 0) << errors();
        return loadExr(path("out.exr"));
    };
    const Exr scenes = render({"--spp", "4"});
    EXPECT_EQ(scenes.attributes.at("seed"), "5");
    EXPECT_EQ(render({"--spp", "4", "--seed", "5"}).channels, scenes.channels);
    const Exr other = render({"--spp", "4", "--seed", "6"});
    EXPECT_EQ(other.attributes.at("seed"), "6");
    EXPECT_NE(other.channels, scenes.channels);
}

TEST_F(Nori, RendersInAnotherSizeAndByAnotherIntegrator) {
    ASSERT_EQ(run({"scenes/small.xml", "--size", "8x5", "--integrator", "direct_mis"}), 0);
    const Exr exr = loadExr(path("scenes/small_3.exr"));
    EXPECT_EQ(exr.channels.at("R").size(), 40u);
    EXPECT_EQ(exr.attributes.at("integrator"), "DirectMultipleImportance");
    EXPECT_EQ(run({"scenes/small.xml", "--integrator", "direct_mist"}), 1);
    EXPECT_NE(errors().find("unknown integrator; known: depth"), std::string::npos) << errors();
}

TEST_F(Nori, SaysWhatIsWrongWithTheCommandLine) {
    const std::vector<std::vector<std::string>> mistakes{
        {},
        {"--bogus", "scenes/small.xml"},
        {"scenes/small.xml", "black.xml"},
        {"scenes/small.xml", "--spp", "0"},
        {"scenes/small.xml", "--spp", "many"},
        {"scenes/small.xml", "-t", "0"},
        {"scenes/small.xml", "--size", "40"},
        {"scenes/small.xml", "--size", "40x36x2"},
        {"scenes/small.xml", "--size", "0x36"},
        {"scenes/small.xml", "--seed", "99999999999"},
        {"scenes/small.xml", "--output"},
        {"scenes/small.xml", "--output", ""}};
    for (const auto &mistake : mistakes) {
        EXPECT_EQ(run(mistake), 2) << testing::PrintToString(mistake);
        EXPECT_NE(errors().find("--help"), std::string::npos) << errors();
    }
    EXPECT_EQ(run({"--help"}), 0);
    EXPECT_NE(output().find("Examples:"), std::string::npos);
    EXPECT_EQ(run({"--version"}), 0);
    EXPECT_EQ(output().find("nori "), 0u);
}

TEST_F(Nori, ReportsScenesThatCannotBeRead) {
    write("typo.xml", "<scene>\n<emitter type=\"aera\"/>\n</scene>");
    write("diffuse.xml", "<bsdf type=\"diffuse\"/>");
    write(
        "huge.xml",
        "<scene><integrator type=\"normals\"/><camera type=\"perspective\"><integer name=\"width\" "
        "value=\"2000000\"/><integer name=\"height\" value=\"2000000\"/></camera></scene>");
    const std::vector<std::pair<std::string, std::string>> cases{
        {"typo.xml", "typo.xml:2: <emitter type=\"aera\">: unknown emitter; known: area"},
        {"absent.xml", "absent.xml: No such file"},
        {"image.pfm", "image.pfm: a scene (.xml) or an image (.exr) is expected"},
        {"image.exr", "Cannot read the OpenEXR file \"image.exr\""},
        {"diffuse.xml", "diffuse.xml: holds a bsdf; a scene is expected"},
        {"huge.xml", "not enough memory for an image of 2000000 x 2000000"},
        {"scenes", "scenes: a scene (.xml) or an image (.exr) is expected"}};
    for (const auto &[file, message] : cases) {
        EXPECT_EQ(run({file}), 1) << file;
        EXPECT_NE(errors().find(message), std::string::npos) << errors();
        EXPECT_EQ(output(), "");
    }
    for (const std::string &name : files("."))
        EXPECT_EQ(name.find(".writing"), std::string::npos) << name;
}

TEST_F(Nori, PrintsTheNumbersOfImages) {
    ASSERT_EQ(run({"scenes/small.xml", "--output", "a"}), 0);
    ASSERT_EQ(run({"scenes/small.xml", "--output", "b", "--seed", "6"}), 0);
    ASSERT_EQ(run({"scenes/small.xml", "--output", "c", "--size", "8x5"}), 0);
    EXPECT_EQ(run({"a.exr"}), 0);
    EXPECT_NE(output().find("a.exr: 40 x 36 pixels"), std::string::npos) << output();
    EXPECT_NE(output().find("pixels: 0 NaN, 0 infinite, 0 negative"), std::string::npos);
    EXPECT_EQ(run({"a.exr", "a.exr"}), 0);
    EXPECT_NE(output().find("RMSE 0\n"), std::string::npos) << output();
    EXPECT_EQ(run({"a.exr", "--reference", "b.exr", "-b"}), 0);
    EXPECT_EQ(output().find("RMSE 0\n"), std::string::npos) << output();
    EXPECT_EQ(run({"a.exr", "c.exr"}), 1);
    EXPECT_NE(errors().find("c.exr: has 8 x 5 pixels"), std::string::npos) << errors();
    EXPECT_EQ(run({"a.exr", "b.exr", "--reference", "b.exr"}), 2);
}

TEST_F(Nori, SaysThatThereCanBeNoWindowBeforeItRenders) {
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY"})
        ::unsetenv(name);
    for (const char *file : {"scenes/small.xml", "black.xml"}) {
        EXPECT_EQ(run({file, "--window", "--output", "none"}), 2);
        EXPECT_NE(errors().find("--screenshot FILE.png needs no display"), std::string::npos);
    }
    EXPECT_FALSE(fs::exists(path("none.exr")));
    EXPECT_EQ(run({"scenes/small.xml", "--output", "none"}), 0) << errors(); // does without
}

TEST_F(Nori, ReportsBeforeRenderingWhereItCannotWrite) {
    fs::create_directory(path("taken.exr"));
    const std::vector<std::pair<std::string, std::string>> cases{
        {"absent/image", "there is no folder absent"},
        {"scenes/", "is a folder"},
        {".", ".: is a folder"},
        {"scenes/..", "is a folder"},
        {"taken", "is a folder"},
        {"/proc/image", "/proc/image.exr: cannot be written"},
        {"black.xml/image", "there is no folder black.xml"}};
    for (const auto &[stem, message] : cases) {
        EXPECT_EQ(run({"scenes/small.xml", "--spp", "10000000", "--output", stem}), 1) << stem;
        EXPECT_NE(errors().find(message), std::string::npos) << errors();
    }
}

TEST_F(Nori, LeavesNothingBehindWhenTheDiskIsFull) {
    write("full.exr", "the image of an earlier run");
    EXPECT_EQ(run({"scenes/small.xml", "--output", "full"}, 1000), 1);
    EXPECT_NE(errors().find("full.exr: cannot be written: "), std::string::npos) << errors();
    EXPECT_EQ(files("."), (std::set<std::string>{"black.xml", "full.exr", "scenes"}));
    std::string text;
    std::getline(std::ifstream(path("full.exr")), text);
    EXPECT_EQ(text, "the image of an earlier run");
}

TEST_F(Nori, WarnsOfAnEmptySceneAndRendersIt) {
    ASSERT_EQ(run({"black.xml"}), 0);
    EXPECT_NE(errors().find("Warning: the scene holds no mesh"), std::string::npos) << errors();
    EXPECT_NE(errors().find("the image is black, and the scene holds no light"), std::string::npos);
    EXPECT_EQ(loadExr(path("black_1.exr")).channels.at("G"),
              std::vector<float>(std::size_t{64} * 64, 0.0f));
}

TEST_F(Nori, WritesWhatIsThereWhenInterrupted) {
    Program program(path("."), {"black.xml", "--spp", "10000000", "--output", "part"});
    program.waitForWarning();
    program.signal(SIGINT);
    const Outcome outcome = program.finish();
    EXPECT_EQ(outcome.code, 130);
    EXPECT_NE(outcome.output.find("(partial)"), std::string::npos) << outcome.output;
    EXPECT_EQ(loadExr(path("part.exr")).attributes.at("partial"), "yes");
    EXPECT_EQ(files("."), (std::set<std::string>{"black.xml", "part.exr", "part.png", "scenes"}));
}

TEST_F(Nori, NeverLeavesHalfAnImageWhenInterruptedTwice) {
    Program program(path("."), {"black.xml", "--spp", "10000000", "--output", "part"});
    program.waitForWarning();
    program.signal(SIGINT);
    program.signal(SIGINT);
    EXPECT_EQ(program.finish().code, 130);
    if (fs::exists(path("part.exr"))) {
        EXPECT_EQ(loadExr(path("part.exr")).attributes.at("partial"), "yes");
    }
}

} // namespace
