// SPDX-License-Identifier: MIT
#pragma once

#include <grader/build/cache.h>
#include <grader/build/diagnostics.h>
#include <grader/build/header_set.h>
#include <grader/sandbox/box.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

namespace grader {

/// A source file to compile.
struct UnitSource {
    std::string name;      ///< `warp.cpp`
    std::string shownName; ///< in messages: the hand-in's own path
    std::string text;
    /// Functions, as the linker knows them, that give way to another object's: here, too.
    std::vector<std::string> givingWay = {};
};

/// A built file in the cache, or why there is none.
using Built = std::variant<std::filesystem::path, BuildFailure>;

/// Changes when the compiler does, without running it: path, size and time of its programs.
/// \throws GraderError  if the machine has no g++
std::string toolchainIdentity();

/// g++ in the box. What was compiled before, by anyone, comes from the cache; what ran into a limit
/// is not tried again by this object, but by the next one. Thread-safe.
class Compiler {
public:
    /// \throws GraderError  if the machine has no g++
    Compiler(const Sandbox &sandbox, const Cache &cache);

    /// \param names  of the headers in messages: staged path to the hand-in's own
    Built compile(const UnitSource &source, const HeaderSet &headers,
                  const std::map<std::string, std::string> &names = {});

    /// Links an executable. \param extras  objects that are taken only where something needs them
    Built link(const std::vector<std::filesystem::path> &objects,
               const std::vector<std::filesystem::path> &extras);

    /// Wall seconds spent in the box so far.
    double compileSeconds() const { return m_compileSeconds; }

    double linkSeconds() const { return m_linkSeconds; }

private:
    std::filesystem::path precompiledHeader();
    Built produce(const std::string &kind, const std::string &key, const std::string &unit,
                  BoxSpec spec, const std::map<std::string, std::string> &names);

    const Sandbox &m_sandbox;
    const Cache &m_cache;
    std::string m_toolchain;                       ///< digest of the compiler's identity
    std::map<std::string, BuildFailure> m_stopped; ///< what ran into a limit, by key
    std::mutex m_mutex;                            ///< of m_stopped
    std::atomic<double> m_compileSeconds{0};
    std::atomic<double> m_linkSeconds{0};
};

} // namespace grader
