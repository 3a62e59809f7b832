// SPDX-License-Identifier: MIT
#pragma once

#include <grader/build/compiler.h>
#include <grader/submission/submission.h>

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace grader {

/// Whose file stands for a unit in a variant.
enum class Origin {
    Starter,        ///< the student edition's: graded bodies throw
    Student,        ///< the hand-in's, or the starter's where it has none or it does not compile
    Reference,      ///< ours; Emitter::sample returns value / pdf, as the header asks
    ReferenceValue, ///< ours; Emitter::sample returns the bare value, as many hand-ins do
};

struct LinkedFunction {
    std::string name;   ///< `Warp::squareToTent`
    std::string symbol; ///< as the linker knows it
};

/// Ours for single functions of a file, in which the others stay the hand-in's. What is ours has
/// no solution of the others in it.
struct FunctionSwap {
    std::string unit; ///< `warp.cpp`
    std::vector<LinkedFunction> ours;
    std::vector<LinkedFunction> theirs; ///< all others that our file defines
};

/// Which units of a variant are not the starter's.
struct VariantPlan {
    std::string name; ///< for reports: `student`, `reference warp and mesh`
    std::map<std::string, Origin> origins;
    std::vector<std::string> judged = {};  ///< units of the hand-in that nothing may stand in for
    std::optional<FunctionSwap> swap = {}; ///< in a unit that is the hand-in's
};

/// A probe that was built from parts.
struct Variant {
    std::string name;
    std::optional<std::filesystem::path> executable;
    std::vector<BuildFailure> failures; ///< of any file that the plan asked for, and of the link
    /// False if a file of ours does not compile with the hand-in's headers, so that the program has
    /// the hand-in's own or none: it fails for more than the files that the plan takes from it.
    bool isWhole = true;
};

/// Builds probes from one hand-in. Thread-safe.
class VariantBuilder {
public:
    VariantBuilder(Compiler &compiler, const Submission &submission, int jobs);

    Variant build(const VariantPlan &plan);

    /// Why the student's file of this name does not compile; nothing if it does or was not sent.
    std::optional<BuildFailure> failureOf(const std::string &unit);

    /// True if the hand-in has a file of this name.
    bool hasUnit(const std::string &unit) const;

    /// True if the hand-in replaces or adds a header.
    bool hasHeaders() const { return m_hasHeaders; }

    /// Compiles every file of the hand-in, on all jobs, so that the rest only links. Headers with
    /// which the base does not compile are left out from then on, unless it is in a file that the
    /// hand-in has, and only got wrong.
    void compileAll(const std::function<void(double fraction)> &progress);

    /// What was built around: forwarded includes, base files left out, extra files.
    std::vector<Note> notes() const;

private:
    struct Unit {
        std::string name;
        Origin origin = Origin::Starter;
        const FunctionSwap *swap = nullptr; ///< of this unit
    };

    struct Object {
        Unit unit;
        Built built;
    };

    struct Headers {
        HeaderSet set;
        std::map<std::string, std::string> names; ///< staged path to what people call it
    };

    static std::vector<Unit> unitsOf(const VariantPlan &plan);
    Object compileUnit(const Unit &unit, const Headers &headers);
    std::vector<Object> compileUnits(const std::vector<Unit> &units, const Headers &headers);
    std::vector<std::filesystem::path> extraObjects(const Headers &headers);
    Variant build(const VariantPlan &plan, const Headers &headers);
    Headers withBaseHeaders() const;
    const UnitSource *studentSource(const std::string &unit) const;
    std::optional<BuildFailure> brokenBase();

    Compiler &m_compiler;
    int m_jobs;
    Headers m_headers; ///< the base's with the hand-in's laid over
    bool m_hasHeaders = false;
    std::map<std::string, UnitSource> m_sources; ///< of the hand-in, by base name
    std::vector<UnitSource> m_extras;
    std::vector<Note> m_notes;
    mutable std::mutex m_mutex; ///< of m_notes
};

/// Runs `task(i)` for i in [0, count) on `jobs` threads; an exception of one is thrown after all
/// have ended.
void parallelFor(std::size_t count, int jobs, const std::function<void(std::size_t)> &task);

} // namespace grader
