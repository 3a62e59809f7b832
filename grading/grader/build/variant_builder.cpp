// SPDX-License-Identifier: MIT
#include "variant_builder.h"

#include <grader/build/starter.h>
#include <grader/error.h>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace grader {

namespace {

/// A file name that is safe on a command line and in a path.
std::string safeName(const std::string &name, std::size_t number) {
    std::string safe = fmt::format("extra{}_{}", number, name);
    std::replace_if(
        safe.begin(), safe.end(),
        [](unsigned char c) { return !(std::isalnum(c) != 0 || c == '.' || c == '_') || c > 127; },
        '_');
    const std::string suffix = ".cpp";
    if (safe.size() < suffix.size() || safe.substr(safe.size() - suffix.size()) != suffix)
        safe += suffix;
    return safe;
}

constexpr char kStagedHeaders[] = "/hand-in/include/";

bool takesReference(const VariantPlan &plan) {
    return plan.swap.has_value() ||
           std::any_of(plan.origins.begin(), plan.origins.end(), [](const auto &each) {
               return each.second == Origin::Reference || each.second == Origin::ReferenceValue;
           });
}

std::vector<std::string> symbolsOf(const std::vector<LinkedFunction> &functions) {
    std::vector<std::string> symbols;
    symbols.reserve(functions.size());
    for (const LinkedFunction &function : functions)
        symbols.push_back(function.symbol);
    return symbols;
}

Files submittedHeaders(const Submission &submission) {
    Files headers;
    for (const SubmittedFile &file : submission.files) {
        if (file.role == FileRole::Header)
            headers[file.name] = file.bytes;
    }
    return headers;
}

} // namespace

void parallelFor(std::size_t count, int jobs, const std::function<void(std::size_t)> &task) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                task(i);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(mutex);
                failure = failure != nullptr ? failure : std::current_exception();
            }
        }
    };
    std::vector<std::thread> threads;
    const std::size_t wanted = std::min<std::size_t>(count, std::max(jobs, 1));
    for (std::size_t i = 1; i < wanted; ++i)
        threads.emplace_back(work);
    work();
    for (std::thread &thread : threads)
        thread.join();
    if (failure != nullptr)
        std::rethrow_exception(failure);
}

VariantBuilder::VariantBuilder(Compiler &compiler, const Submission &submission, int jobs)
    : m_compiler(compiler),
      m_jobs(jobs),
      m_headers{overlayHeaders(starterBase().headers, submittedHeaders(submission)), {}} {
    for (const auto &[name, text] : m_headers.set.files)
        m_headers.names[kStagedHeaders + name] = name;
    for (const SubmittedFile &file : submission.files) {
        m_hasHeaders = m_hasHeaders || file.role == FileRole::Header;
        if (file.role == FileRole::Header)
            m_headers.names[kStagedHeaders + ("nori/" + file.name)] = file.path;
        else if (file.role == FileRole::Source)
            m_sources[file.name] = {file.name, file.path, file.bytes};
        else if (file.role == FileRole::Extra)
            m_extras.push_back({safeName(file.name, m_extras.size()), file.path, file.bytes});
        else
            continue;
        for (const std::string &spelling : addForwards(file.bytes, m_headers.set))
            m_notes.push_back({Note::Level::Odd, file.path,
                               fmt::format("includes \"{}\", which Linux does not find; \"{}\" was "
                                           "taken",
                                           spelling, m_headers.set.forwards.at(spelling))});
    }
}

bool VariantBuilder::hasUnit(const std::string &unit) const {
    return m_sources.count(unit) != 0;
}

const UnitSource *VariantBuilder::studentSource(const std::string &unit) const {
    const auto found = m_sources.find(unit);
    return found != m_sources.end() ? &found->second : nullptr;
}

std::optional<BuildFailure> VariantBuilder::failureOf(const std::string &unit) {
    const UnitSource *source = studentSource(unit);
    if (source == nullptr)
        return std::nullopt;
    Built built = m_compiler.compile(*source, m_headers.set, m_headers.names);
    if (auto *failure = std::get_if<BuildFailure>(&built))
        return std::move(*failure);
    return std::nullopt;
}

VariantBuilder::Object VariantBuilder::compileUnit(const Unit &unit, const Headers &headers) {
    const auto text = [&](const Files &files) -> const std::string * {
        const auto found = files.find(unit.name);
        return found != files.end() ? &found->second : nullptr;
    };
    Origin origin = unit.origin;
    if (origin == Origin::Student) {
        if (const UnitSource *source = studentSource(unit.name)) {
            UnitSource part = *source;
            if (unit.swap != nullptr)
                part.givingWay = symbolsOf(unit.swap->ours);
            return {unit, m_compiler.compile(part, headers.set, headers.names)};
        }
        origin = Origin::Starter;
    }
    const std::string *source =
        text(origin == Origin::Starter ? starterBase().units : referenceBase().units);
    if (source == nullptr)
        source = text(probeUnits());
    if (source == nullptr)
        return {unit, std::filesystem::path()}; // the starter has no such file
    const std::string define =
        origin == Origin::ReferenceValue ? "#define NORI_SAMPLE_RETURNS_VALUE 1\n#line 1\n" : "";
    std::string flat = unit.name;
    std::replace(flat.begin(), flat.end(), '/', '_');
    UnitSource ours{flat, "the base's " + unit.name, define + *source};
    if (unit.swap != nullptr) {
        std::vector<std::string> names;
        for (const LinkedFunction &function : unit.swap->ours)
            names.push_back(function.name);
        ours.text = starterText(ours.text, unit.name, names).value();
        ours.givingWay = symbolsOf(unit.swap->theirs);
    }
    return {unit, m_compiler.compile(ours, headers.set, headers.names)};
}

std::vector<VariantBuilder::Object> VariantBuilder::compileUnits(const std::vector<Unit> &units,
                                                                 const Headers &headers) {
    std::vector<Object> objects(units.size());
    parallelFor(units.size(), m_jobs,
                [&](std::size_t i) { objects[i] = compileUnit(units[i], headers); });
    return objects;
}

std::vector<std::filesystem::path> VariantBuilder::extraObjects(const Headers &headers) {
    std::vector<std::filesystem::path> objects;
    for (const UnitSource &extra : m_extras) {
        const Built built = m_compiler.compile(extra, headers.set, headers.names);
        if (const auto *object = std::get_if<std::filesystem::path>(&built))
            objects.push_back(*object);
    }
    return objects;
}

std::optional<BuildFailure> VariantBuilder::brokenBase() {
    std::vector<std::string> units;
    for (const Files *files : {&starterBase().units, &probeUnits()}) {
        for (const auto &[unit, text] : *files)
            units.push_back(unit);
    }
    for (const std::string &unit : units) {
        const Object object = compileUnit({unit, Origin::Starter}, m_headers);
        const auto *failure = std::get_if<BuildFailure>(&object.built);
        const bool matters = failure != nullptr && !isPlugin(unit);
        if (matters && !hasUnit(unit))
            return *failure;
    }
    return std::nullopt;
}

void VariantBuilder::compileAll(const std::function<void(double fraction)> &progress) {
    std::vector<Unit> units;
    for (const auto &[unit, source] : m_sources)
        units.push_back({unit, Origin::Student});
    for (const auto &[unit, text] : starterBase().units)
        units.push_back({unit, Origin::Starter});
    for (const auto &[unit, text] : probeUnits())
        units.push_back({unit, Origin::Starter});
    std::atomic<std::size_t> done{0};
    parallelFor(units.size(), m_jobs, [&](std::size_t i) {
        compileUnit(units[i], m_headers);
        progress(static_cast<double>(++done) / static_cast<double>(units.size()));
    });
    // What does not need headers that break everything is judged without them.
    if (const auto failure = m_hasHeaders ? brokenBase() : std::nullopt) {
        m_notes.push_back({Note::Level::Odd, "",
                           "The base's own headers were taken, because it does not compile with "
                           "those of the hand-in: " +
                               failure->describe()});
        m_headers = withBaseHeaders();
    }
    for (const UnitSource &extra : m_extras) {
        Built built = m_compiler.compile(extra, m_headers.set, m_headers.names);
        if (auto *failure = std::get_if<BuildFailure>(&built)) {
            failure->unit = std::filesystem::path(extra.shownName).filename().string();
            m_notes.push_back(
                {Note::Level::Odd, extra.shownName,
                 "an additional file that does not compile; nothing needs it unless a "
                 "link error says so: " +
                     failure->describe()});
        }
    }
}

VariantBuilder::Headers VariantBuilder::withBaseHeaders() const {
    Headers headers = m_headers;
    for (const auto &[name, text] : starterBase().headers) {
        headers.set.files[name] = text;
        headers.names[kStagedHeaders + name] = name;
    }
    return headers;
}

Variant VariantBuilder::build(const VariantPlan &plan) {
    Variant variant = build(plan, m_headers);
    const bool isFaithful = variant.executable && (variant.isWhole || !takesReference(plan));
    if (isFaithful || !m_hasHeaders)
        return variant;
    // What judges one file needs none of the others' headers, unless that file does.
    Variant withBase = build(plan, withBaseHeaders());
    const bool judgesIt = std::none_of(
        withBase.failures.begin(), withBase.failures.end(), [&](const BuildFailure &failure) {
            return std::count(plan.judged.begin(), plan.judged.end(), failure.unit) != 0;
        });
    return withBase.executable && judgesIt ? withBase : variant;
}

std::vector<VariantBuilder::Unit> VariantBuilder::unitsOf(const VariantPlan &plan) {
    std::vector<Unit> units;
    for (const auto &[unit, text] : probeUnits())
        units.push_back({unit, Origin::Starter});
    for (const auto &[unit, text] : starterBase().units) {
        if (plan.origins.count(unit) == 0)
            units.push_back({unit, Origin::Starter});
    }
    const FunctionSwap *swap = plan.swap ? &*plan.swap : nullptr;
    for (const auto &[unit, origin] : plan.origins)
        units.push_back({unit, origin, swap != nullptr && swap->unit == unit ? swap : nullptr});
    if (swap != nullptr)
        units.push_back({swap->unit, Origin::Reference, swap});
    return units;
}

Variant VariantBuilder::build(const VariantPlan &plan, const Headers &headers) {
    Variant variant;
    variant.name = plan.name;
    std::vector<std::filesystem::path> objects;
    bool linkable = true;
    for (Object &object : compileUnits(unitsOf(plan), headers)) {
        const bool isStudents = object.unit.origin == Origin::Student;
        if (const auto *failure = std::get_if<BuildFailure>(&object.built)) {
            variant.failures.push_back(*failure);
            variant.isWhole = variant.isWhole && isStudents;
            // A student's file that does not compile costs only what it holds: the starter's
            // stands in, where there is one. One of ours that a changed header breaks is
            // replaced by the student's own; if there is none, a plugin (a new pure virtual) is
            // left out, and scenes that need it will say so. For single functions nothing stands
            // in.
            if (hasUnit(object.unit.name) && object.unit.swap == nullptr)
                object = compileUnit(
                    {object.unit.name, isStudents ? Origin::Starter : Origin::Student}, headers);
            if (std::holds_alternative<BuildFailure>(object.built)) {
                linkable = linkable && isPlugin(object.unit.name);
                continue;
            }
        }
        const auto &file = std::get<std::filesystem::path>(object.built);
        if (!file.empty())
            objects.push_back(file);
    }
    if (!linkable)
        return variant;
    Built built = m_compiler.link(objects, extraObjects(headers));
    if (auto *failure = std::get_if<BuildFailure>(&built))
        variant.failures.push_back(std::move(*failure));
    else
        variant.executable = std::get<std::filesystem::path>(built);
    return variant;
}

std::vector<Note> VariantBuilder::notes() const {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_notes;
}

} // namespace grader
