// SPDX-License-Identifier: MIT
#include "compiler.h"

#include <grader/digest.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <fmt/format.h>

#include <sys/stat.h>

#include <algorithm>
#include <mutex>

namespace grader {

namespace {

constexpr char kGxx[] = "/usr/bin/g++";

/// Another one only for `./run stability`, which asks whether verdicts hang on it.
#ifndef NORI_HAND_IN_OPTIMISATION
#define NORI_HAND_IN_OPTIMISATION "-O2"
#endif

/// The course's own flags as far as they decide numbers; no -march, so that every machine gets the
/// same ones. The limits make errors short and template or constexpr bombs end.
const std::vector<std::string> kFlags = {"-std=gnu++17",
                                         NORI_HAND_IN_OPTIMISATION,
                                         "-w",
                                         "-pipe",
                                         "-fmax-errors=20",
                                         "-ftemplate-depth=400",
                                         "-fconstexpr-ops-limit=20000000",
                                         "-fdiagnostics-color=never",
                                         "-fno-diagnostics-show-caret",
                                         "-D_USE_MATH_DEFINES"};

const std::vector<std::string> kIncludeFlags = {
    "-I/hand-in/include", "-I/hand-in/forward",   "-iquote",    "/hand-in/include/nori",
    "-isystem",           "/usr/include/eigen3",  "-isystem",   "/usr/include/Imath",
    "-isystem",           "/usr/include/OpenEXR", "-idirafter", "/hand-in/include/nori"};

const std::vector<std::string> kLibraries = {
    "-lembree3",   "-ltbb",     "-lOpenEXR-3_1", "-lIex-3_1", "-lIlmThread-3_1",
    "-lImath-3_1", "-lpugixml", "-lpng",         "-ljpeg",    "-lpthread"};

/// A file's calls of its own functions, too, ask the linker who defines them.
constexpr char kOpenCalls[] = "-fPIC";

/// What makes most of a unit's compile time and no submission changes.
constexpr char kPrecompiled[] = "#include <Eigen/Core>\n"
                                "#include <Eigen/Geometry>\n"
                                "#include <Eigen/LU>\n"
                                "#include <algorithm>\n#include <chrono>\n#include <cmath>\n"
                                "#include <functional>\n#include <iostream>\n#include <map>\n"
                                "#include <memory>\n#include <random>\n#include <sstream>\n"
                                "#include <stdexcept>\n#include <string>\n#include <vector>\n"
                                "#include <math.h>\n#include <stdint.h>\n#include <stdlib.h>\n";

void append(std::vector<std::string> &list, const std::vector<std::string> &more) {
    list.insert(list.end(), more.begin(), more.end());
}

/// Keys are made of named parts; each is preceded by its length, so that no two lists of parts run
/// together into the same key.
std::string keyOf(const std::vector<std::string> &parts) {
    std::string joined;
    for (const std::string &part : parts)
        joined += fmt::format("{}:{}", part.size(), part);
    return sha256Hex(joined);
}

/// A folder of the cache that holds exactly `files`.
std::filesystem::path stage(const Cache &cache, const Files &files) {
    std::vector<std::string> parts;
    for (const auto &[name, text] : files) {
        parts.push_back(name);
        parts.push_back(text);
    }
    const std::filesystem::path folder = cache.entry("staged", keyOf(parts));
    const std::filesystem::path complete = folder / ".complete";
    if (!std::filesystem::exists(complete)) {
        for (const auto &[name, text] : files)
            writeTextFile(folder / name, text);
        writeTextFile(complete, "");
    }
    return folder;
}

Files forwardFiles(const HeaderSet &headers) {
    Files files;
    for (const auto &[spelling, name] : headers.forwards)
        files[spelling] = fmt::format("#include <{}>\n", name);
    return files;
}

} // namespace

std::string toolchainIdentity() {
    std::string identity;
    for (const char *file : {kGxx, "/usr/bin/ld", "/usr/bin/as"}) {
        std::error_code error;
        const auto real = std::filesystem::canonical(file, error);

        struct stat status {};

        if (error || ::stat(real.c_str(), &status) != 0)
            throw GraderError(fmt::format("{}: not found; install the package g++", file));
        identity += fmt::format("{} {} {}\n", real.string(), status.st_size, status.st_mtime);
    }
    return identity;
}

Compiler::Compiler(const Sandbox &sandbox, const Cache &cache)
    : m_sandbox(sandbox), m_cache(cache), m_toolchain(sha256Hex(toolchainIdentity())) {}

Built Compiler::produce(const std::string &kind, const std::string &key, const std::string &unit,
                        BoxSpec spec, const std::map<std::string, std::string> &names) {
    const std::filesystem::path result = m_cache.entry(kind, key);
    const std::filesystem::path failed = m_cache.entry(kind, key, ".failed");
    if (std::filesystem::exists(result))
        return result;
    if (std::filesystem::exists(failed))
        return parseDiagnostics(unit, readTextFile(failed), names);
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        if (const auto stopped = m_stopped.find(key); stopped != m_stopped.end())
            return stopped->second;
    }

    const std::filesystem::path scratch = m_cache.makeScratch();
    spec.binds.push_back({scratch, "/out", true});
    spec.mayFork = true;
    spec.limits = {.cpu = std::chrono::seconds(60),
                   .wall = std::chrono::seconds(180),
                   .memoryBytes = std::uint64_t{2} << 30,
                   .fileBytes = std::uint64_t{256} << 20,
                   .logBytes = std::uint64_t{1} << 20,
                   .processes = 64};
    const BoxOutcome outcome = m_sandbox.run(spec);
    const std::filesystem::path output = scratch / "output";
    const auto *exited = std::get_if<BoxExited>(&outcome.end);
    std::error_code error;
    const bool made =
        exited != nullptr && exited->code == 0 &&
        std::filesystem::is_regular_file(std::filesystem::symlink_status(output, error));
    if (const std::string reason = ownFailure(outcome.end); !reason.empty()) {
        std::filesystem::remove_all(scratch, error);
        throw GraderError("the compiler was not run to its end in the sandbox: " + reason);
    }
    if (made)
        writeTextFile(result, readTextFile(output));
    std::filesystem::remove_all(scratch, error);
    (kind == "executables" ? m_linkSeconds : m_compileSeconds) =
        (kind == "executables" ? m_linkSeconds : m_compileSeconds) + outcome.wallSeconds;
    if (made)
        return result;

    if (exited != nullptr) {
        writeTextFile(failed, outcome.log);
        BuildFailure failure = parseDiagnostics(unit, outcome.log, names);
        if (failure.errors.empty())
            failure.errors.push_back({"", 0, 0, outcome.log.substr(0, 500)});
        return failure;
    }
    // Ran into a limit: kept for this hand-in only, another day's try may do better.
    BuildFailure failure = parseDiagnostics(unit, outcome.log, names);
    failure.errors.insert(failure.errors.begin(),
                          {"", 0, 0, "the compiler was stopped: " + describe(outcome.end)});
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_stopped[key] = failure;
    return failure;
}

std::filesystem::path Compiler::precompiledHeader() {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    const std::string key =
        keyOf({m_toolchain, fmt::format("{}", fmt::join(kFlags, " ")), kPrecompiled});
    const std::filesystem::path folder = m_cache.entry("precompiled", key);
    if (std::filesystem::exists(folder / "pch.h.gch"))
        return folder;
    writeTextFile(folder / "pch.h", kPrecompiled);

    BoxSpec spec;
    spec.argv = {kGxx};
    append(spec.argv, kFlags);
    append(spec.argv, {"-isystem", "/usr/include/eigen3", "-x", "c++-header", "/pch/pch.h", "-o",
                       "/out/output"});
    spec.binds = {{folder, "/pch", false}};
    const Built built = produce("objects", sha256Hex("precompiled" + key), "pch.h", spec, {});
    if (const auto *failure = std::get_if<BuildFailure>(&built))
        throw GraderError("the base's common headers do not compile: " + failure->describe());
    writeTextFile(folder / "pch.h.gch", readTextFile(std::get<std::filesystem::path>(built)));
    return folder;
}

Built Compiler::compile(const UnitSource &source, const HeaderSet &headers,
                        const std::map<std::string, std::string> &names) {
    std::vector<std::string> parts = {m_toolchain,
                                      fmt::format("{}", fmt::join(kFlags, " ")),
                                      fmt::format("{}", fmt::join(kIncludeFlags, " ")),
                                      kPrecompiled,
                                      source.name,
                                      source.text};
    for (const std::string &header : includeClosure(source.text, headers)) {
        parts.push_back(header);
        parts.push_back(headers.files.at(header));
    }
    for (const auto &[spelling, name] : headers.forwards)
        parts.push_back(fmt::format("{} = {}", spelling, name));
    std::string text = source.text;
    if (!source.givingWay.empty()) {
        // g++ knows no weak function by its symbol ahead of its declaration; the assembler does.
        text =
            fmt::format("asm(\".weak {}\");\n#line 1\n", fmt::join(source.givingWay, "\\n.weak ")) +
            text;
        append(parts, {kOpenCalls, text});
    }
    const std::string key = keyOf(parts);

    std::map<std::string, std::string> shown = names;
    shown["src/" + source.name] = source.shownName.empty() ? source.name : source.shownName;
    BoxSpec spec;
    spec.workingFolder = "/hand-in";
    spec.argv = {kGxx};
    append(spec.argv, kFlags);
    if (!source.givingWay.empty())
        spec.argv.emplace_back(kOpenCalls);
    append(spec.argv, {"-include", "/pch/pch.h"});
    append(spec.argv, kIncludeFlags);
    append(spec.argv, {"-c", "src/" + source.name, "-o", "/out/output"});
    spec.binds = {{precompiledHeader(), "/pch", false},
                  {stage(m_cache, headers.files), "/hand-in/include", false},
                  {stage(m_cache, forwardFiles(headers)), "/hand-in/forward", false},
                  {stage(m_cache, {{source.name, text}}), "/hand-in/src", false}};
    return produce("objects", key, source.name, std::move(spec), shown);
}

Built Compiler::link(const std::vector<std::filesystem::path> &objects,
                     const std::vector<std::filesystem::path> &extras) {
    std::vector<std::string> parts = {m_toolchain, fmt::format("{}", fmt::join(kLibraries, " "))};
    BoxSpec spec;
    spec.argv = {kGxx, "-o", "/out/output"};
    const auto add = [&](const std::filesystem::path &object) {
        const std::string inside = fmt::format("/objects/{}.o", spec.binds.size());
        parts.push_back(object.string());
        spec.binds.push_back({object, inside, false});
        spec.argv.push_back(inside);
    };
    for (const auto &object : objects)
        add(object);
    parts.emplace_back("extras");
    if (!extras.empty()) {
        // --start-lib: the objects that follow are searched like the members of an archive.
        spec.argv.insert(spec.argv.begin() + 1, "-fuse-ld=gold");
        spec.argv.emplace_back("-Wl,--start-lib");
        for (const auto &object : extras)
            add(object);
        spec.argv.emplace_back("-Wl,--end-lib");
    }
    append(spec.argv, kLibraries);
    const Built built = produce("executables", keyOf(parts), "link", std::move(spec), {});
    if (const auto *file = std::get_if<std::filesystem::path>(&built)) {
        using std::filesystem::perms;
        std::filesystem::permissions(*file,
                                     perms::owner_exec | perms::group_exec | perms::others_exec,
                                     std::filesystem::perm_options::add);
    }
    return built;
}

} // namespace grader
