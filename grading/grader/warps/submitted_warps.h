// SPDX-License-Identifier: MIT
#pragma once

#include <battery/callables.h>
#include <catalog/warp_entry.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace grader {

/// The warps of a hand-in, built in the box on the student edition and asked there: nothing of it
/// is loaded here. Each call starts a process of its own, so that one may throw, hang or crash.
class SubmittedWarps {
public:
    /// \param path      a hand-in (archive or folder), or one C++ file of any name, which stands
    /// for
    ///                  warp.cpp
    /// \param jobs      compilers at a time
    /// \param progress  of the building, in [0, 1]
    /// \throws GraderError  if it cannot be read, has no warp.cpp, or the machine has no sandbox;
    ///                      if it does not compile, with the errors as `FILE:LINE:COLUMN: MESSAGE`
    SubmittedWarps(const std::filesystem::path &path, int jobs,
                   const std::function<void(double fraction)> &progress);
    ~SubmittedWarps();
    SubmittedWarps(const SubmittedWarps &) = delete;
    SubmittedWarps(SubmittedWarps &&) = delete;
    SubmittedWarps &operator=(const SubmittedWarps &) = delete;
    SubmittedWarps &operator=(SubmittedWarps &&) = delete;

    /// Name of the hand-in or file.
    [[nodiscard]] const std::string &name() const;

    /// What was built around, one sentence each: forwarded includes, files left out.
    [[nodiscard]] const std::vector<std::string> &notes() const;

    /// \throws battery::NotImplemented, std::runtime_error  what the code threw, or how its process
    /// ended
    [[nodiscard]] std::vector<battery::Output>
    warp(const catalog::WarpEntry &entry, std::span<const battery::Input> inputs, double a) const;

    /// \throws as warp()
    [[nodiscard]] std::vector<float> density(const catalog::WarpEntry &entry,
                                             std::span<const battery::Output> points,
                                             double a) const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace grader
