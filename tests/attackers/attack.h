// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/box.h>

#include <string>
#include <vector>

namespace attack {

/// What kind of program an attacker is, and so how it is started.
enum class Kind {
    Hostile,  ///< a mode of tests/grading/grader/sandbox/hostile.cpp, in a probe's box
    Escape,   ///< a program of escapes.cpp, in a probe's box
    Compiler, ///< the same, or a mode of hostile.cpp, in a compiler's box: it may start processes
    Probe,    ///< a mode of tests/grading/grader/prober/hostile_probe.cpp, asked two questions
    Cheat,    ///< a mode of cheats.cpp, judged by the checks of the uniform disk
    Source,   ///< a source file, given to the compiler
    HandIn, ///< the same, added to the starter's warp.cpp: it is linked and runs as a hand-in does
};

/// How an attack must be seen to end.
enum class End {
    Any,    ///< whatever it does to itself
    Exit,   ///< it comes to its end, and says that it has tried
    Leave,  ///< it leaves before that, with another code than 0
    Signal, ///< by its own signal
    Cpu,    ///< by the limit of CPU time
    Wall,   ///< by the limit of time
    Memory, ///< by the limit of memory at S3; at S2 its allocations fail, and it comes to its end
    Log,    ///< by the limit of what it prints
    Built,  ///< it compiles, and a hand-in links: there is nothing to find
    Failed, ///< it does not compile
};

struct Attack {
    char group; ///< A faking the verdict, B escape and damage, C at compile time, D the grader's
                ///< readers, E right numbers by a wrong method
    Kind kind;
    const char *name; ///< of the mode, program or source
    const char *tries;
    End end;
    /// The check that it wants to pass without doing what it asks; the rest of a cheat is right and
    /// worth its points. Null: nothing in it is.
    const char *claim = nullptr;
    grader::SandboxLevel contained = grader::SandboxLevel::S2; ///< weakest level that contains it
};

const std::vector<Attack> &attackTable();

/// The text of a Kind::Source or Kind::HandIn attack. \param host  a file of this machine that it
/// must not see
std::string attackSource(const std::string &name, const std::string &host);

} // namespace attack
