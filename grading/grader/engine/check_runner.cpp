// SPDX-License-Identifier: MIT
#include "check_runner.h"

#include <grader/diagnosis/catalogue.h>
#include <grader/engine/box_context.h>
#include <grader/engine/warp_plan.h>

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace grader {

namespace {

CheckResult withVerdict(const Check &check, Verdict verdict, std::string message) {
    CheckResult result;
    result.id = check.id;
    result.verdict = verdict;
    result.message = std::move(message);
    return result;
}

/// Larger is better for the student.
int rank(Verdict verdict) {
    switch (verdict) {
    case Verdict::Pass:
        return 3;
    case Verdict::Inconclusive:
    case Verdict::Infra:
    case Verdict::Human:
        return 2;
    case Verdict::Fail:
        return 1;
    default:
        return 0;
    }
}

bool isAtFault(Verdict verdict) {
    return rank(verdict) < 2;
}

/// Keeps what is likely: nothing where nothing is wrong.
void tellDiagnoses(CheckResult &result) {
    result.diagnoses =
        isAtFault(result.verdict) ? bestGuesses(result.diagnoses) : std::vector<Guess>{};
    const Diagnosis *first =
        result.diagnoses.empty() ? nullptr : findDiagnosis(result.diagnoses.front().id);
    result.diagnosis = first != nullptr ? first->in(Language::English).sentence : "";
}

} // namespace

CheckRunner::CheckRunner(const Sandbox &sandbox, const EngineOptions &options,
                         std::filesystem::path referenceProbe, VariantBuilder &builder,
                         std::string submissionDigest)
    : m_sandbox(sandbox),
      m_options(options),
      m_referenceProbe(std::move(referenceProbe)),
      m_builder(builder),
      m_digest(std::move(submissionDigest)) {}

const Variant &CheckRunner::variant(const VariantPlan &plan, const Group &group) {
    const std::lock_guard<std::mutex> lock(m_mutex);
    const std::string key = group.id + "/" + plan.name;
    const auto found = m_variants.find(key);
    if (found != m_variants.end())
        return found->second;
    return m_variants.emplace(key, m_builder.build(plan)).first->second;
}

const Variant &CheckRunner::ownVariant(const Group &group) {
    const Variant &own = variant(studentPlan(group), group);
    if (own.executable || own.failures.empty() || own.failures.back().unit != "link")
        return own;
    // It may call what is in another of the hand-in's files.
    const Variant &whole = variant(wholePlan(group), group);
    return whole.executable ? whole : own;
}

bool CheckRunner::upstreamAtFault(const Group &group) const {
    return std::any_of(group.upstream.begin(), group.upstream.end(),
                       [&](const std::string &id) { return m_atFault.count(id) != 0; });
}

CheckResult CheckRunner::runOn(const Check &check, const Variant &variant,
                               ReferenceAnswers &known) {
    const std::string key = check.id + "/" + variant.name;
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        const auto found = m_measured.find(key);
        if (found != m_measured.end())
            return found->second;
    }
    CheckResult result = measure(check, variant, known);
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_measured.emplace(key, result);
    return result;
}

CheckResult CheckRunner::measure(const Check &check, const Variant &variant,
                                 ReferenceAnswers &known) {
    if (!variant.executable) {
        const BuildFailure failure =
            variant.failures.empty() ? BuildFailure{} : variant.failures.back();
        // Our own base over our own headers always builds.
        const bool ours =
            failure.unit != "link" && !m_builder.hasUnit(failure.unit) && !m_builder.hasHeaders();
        CheckResult result =
            withVerdict(check, ours ? Verdict::Infra : Verdict::BuildError, failure.describe());
        result.variant = variant.name;
        return result;
    }
    BoxContext context(m_sandbox, m_options.interrupted, *variant.executable, m_referenceProbe,
                       known, m_options.seedHex + "|" + check.id, m_digest);
    CheckResult result;
    try {
        result = check.run(context);
    } catch (const std::logic_error &error) { // a number that no test foresaw: the others go on
        result = withVerdict(check, Verdict::Infra,
                             fmt::format("The check could not judge the answer: {}", error.what()));
    }
    tellDiagnoses(result);
    result.id = check.id;
    result.variant = variant.name;
    m_sampleSeconds += context.sampleSeconds();
    return result;
}

std::vector<VariantPlan> CheckRunner::plansFor(const Group &group, bool excusable) {
    if (!excusable)
        return followThroughPlans(group);
    std::vector<VariantPlan> plans = mendedPlans(group, m_atFault, m_conventions);
    const bool goTogether = std::any_of(plans.begin(), plans.end(), [&](const VariantPlan &plan) {
        const Variant &built = variant(plan, group);
        return built.executable && built.failures.empty();
    });
    return goTogether ? plans : followThroughPlans(group, m_conventions);
}

void CheckRunner::remember(const Group &group, const std::vector<CheckResult> &results) {
    bool evalIsRight = true;
    std::set<bool> divides;
    for (const CheckResult &result : results) {
        const Check *check = findCheck(result.id);
        const bool excuses = check == nullptr || !check->excusesNobody;
        // With an integrator under suspicion the choice is judged with ours, too.
        const bool isUndone = group.id == "importance" && result.verdict == Verdict::Missing;
        if ((isAtFault(result.verdict) && !isUndone && excuses) ||
            m_chosenWrongly.count(result.id) != 0)
            m_atFault.insert(group.id);
        if (result.id == group.id + ".eval")
            evalIsRight = !isAtFault(result.verdict);
        if (result.sampleDivides)
            divides.insert(*result.sampleDivides);
    }
    // What sample gives is compared with what eval gives.
    if (evalIsRight && divides.size() == 1)
        m_conventions[group.own.back()] = *divides.begin();
}

CheckResult CheckRunner::follow(const Check &check, const Group &group, CheckResult first,
                                ReferenceAnswers &known) {
    const Variant &own = ownVariant(group);
    // Its own files compile, or there would be no checks: another one holds up the program.
    const bool isHeldUp = !own.executable && own.failures.back().unit != "link";
    const bool excusable = isHeldUp || upstreamAtFault(group);
    // The integrator and the emitters may each be right and yet not agree on who divides by the
    // density: then nothing upstream is charged, and the disagreement is the integrator's.
    const bool mayDisagree = group.id == "direct_ems" && first.verdict == Verdict::Fail;
    if (!isAtFault(first.verdict) || (!excusable && !mayDisagree))
        return first;
    CheckResult best = first;
    // What is held against it where nobody has chosen wrongly: without what was charged upstream.
    CheckResult withOwnChoice = first;
    bool onlyChoice = false;      // passes only where our Scene chooses the lights
    bool replaced = false;        // what it stands on
    bool isDoneElsewhere = false; // the hand-in's integrator does what ours leaves to its Scene
    for (const VariantPlan &plan : plansFor(group, excusable)) {
        const Variant &built = variant(plan, group);
        replaced = replaced || (built.executable && built.isWhole);
        const auto scene = plan.origins.find(kSceneUnit);
        const bool isOurChoice = scene != plan.origins.end() && scene->second == Origin::Starter;
        CheckResult result = runOn(check, built, known);
        if (excusable && !isOurChoice && rank(result.verdict) >= rank(withOwnChoice.verdict))
            withOwnChoice = result;
        isDoneElsewhere = isDoneElsewhere || (excusable && first.verdict == Verdict::Fail &&
                                              result.verdict == Verdict::Missing);
        if (rank(result.verdict) > rank(best.verdict))
            best = std::move(result);
        if (best.verdict == Verdict::Pass) {
            // Our emitters may not tell the hand-in's Scene what its own do.
            onlyChoice = isOurChoice && (!excusable || keepsEmitters(plan));
            break;
        }
    }
    if (excusable && !replaced && isAtFault(best.verdict))
        best = withVerdict(check, Verdict::Human,
                           "Other files of the hand-in are wrong, and ours cannot stand for them, "
                           "as they do not go with its files.");
    else if (isDoneElsewhere && isAtFault(best.verdict))
        best = withVerdict(check, Verdict::Human,
                           "The lights are chosen in a file that is wrong otherwise, and ours does "
                           "not choose them like that.");
    if (onlyChoice) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_chosenWrongly.emplace(check.id, std::move(withOwnChoice));
        return best;
    }
    if (excusable)
        return best;
    if (best.verdict == Verdict::Pass) {
        first.diagnoses.push_back({"ems.convention", 0.8});
        tellDiagnoses(first);
    }
    return first;
}

void CheckRunner::followWarps(const Group &group, const std::vector<const Check *> &checks,
                              std::vector<CheckResult> &results) {
    struct Failed {
        std::string item;
        std::vector<std::size_t> checks;
        std::set<std::string> excusedBy; ///< functions that were ours when it was right
    };

    std::map<std::string, Failed> failed; // by function
    for (std::size_t i = 0; i < checks.size(); ++i) {
        if (!isAtFault(results[i].verdict))
            continue;
        Failed &function = failed[checks[i]->function];
        function.item = checks[i]->item;
        function.checks.push_back(i);
    }
    const Variant &own = ownVariant(group);
    // Where a warp is not there at all, ours must not stand in for it unasked.
    if (failed.size() < 2 || !own.executable)
        return;
    const VariantPlan plan =
        own.name == studentPlan(group).name ? studentPlan(group) : wholePlan(group);
    for (auto &[name, function] : failed) {
        std::set<std::string> others;
        for (const auto &[otherName, other] : failed) {
            if (other.item != function.item && other.excusedBy.count(name) == 0)
                others.insert(otherName);
        }
        if (others.empty())
            continue;
        const Variant &built = variant(mendedWarps(plan, others), group);
        if (!built.executable || !built.isWhole)
            continue;
        for (const std::size_t i : function.checks) {
            ReferenceAnswers known;
            CheckResult result = runOn(*checks[i], built, known);
            if (result.verdict == Verdict::Timeout)
                break; // it does not end by itself
            if (result.verdict != Verdict::Pass && result.verdict != Verdict::Inconclusive)
                continue;
            results[i] = std::move(result);
            function.excusedBy = others;
        }
    }
}

void CheckRunner::startAnew() {
    m_atFault.clear();
    m_chosenWrongly.clear();
    m_conventions.clear();
    m_endless.clear();
}

void CheckRunner::settle(std::vector<CheckResult> &results) const {
    const bool charged = std::any_of(kChoiceGroups.begin(), kChoiceGroups.end(),
                                     [&](const char *id) { return m_atFault.count(id) != 0; });
    if (charged)
        return;
    for (CheckResult &result : results) {
        const auto found = m_chosenWrongly.find(result.id);
        if (found != m_chosenWrongly.end())
            result = found->second;
    }
}

std::vector<CheckResult> CheckRunner::runGroup(const Group &group,
                                               const std::vector<const Check *> &checks,
                                               const std::function<void()> &checkDone) {
    std::vector<CheckResult> results(checks.size());
    const auto setAll = [&](Verdict verdict, const std::string &message) {
        for (std::size_t i = 0; i < checks.size(); ++i) {
            results[i] = withVerdict(*checks[i], verdict, message);
            checkDone();
        }
        // The base's Scene is complete: what stands on it stands on nothing wrong.
        if (!checks.empty() && (verdict != Verdict::Missing || group.own.back() != kSceneUnit))
            m_atFault.insert(group.id);
        return results;
    };

    const std::string &lead = group.own.back();
    if (!m_builder.hasUnit(lead))
        return setAll(Verdict::Missing, lead + " was not handed in.");
    for (const std::string &unit : group.own) {
        if (const auto failure = m_builder.failureOf(unit))
            return setAll(Verdict::BuildError, failure->describe());
    }

    // Code that never ends costs one time limit, not one per check: the first check of each item
    // and function goes ahead, and what lies downstream of such code is followed through at once.
    const bool endlessUpstream =
        std::any_of(group.upstream.begin(), group.upstream.end(),
                    [&](const std::string &id) { return m_endless.count(id) != 0; });
    const auto codeOf = [](const Check &check) {
        return check.function.empty() ? check.item : check.function;
    };
    std::map<std::string, std::string> endless; // what does not end, by codeOf()
    std::vector<std::size_t> ahead;
    std::vector<std::size_t> after;
    for (std::size_t i = 0; i < checks.size(); ++i) {
        const bool isFirst = i == 0 || codeOf(*checks[i]) != codeOf(*checks[i - 1]);
        (isFirst ? ahead : after).push_back(i);
        if (endlessUpstream)
            endless[codeOf(*checks[i])] = "code that this needs";
    }
    std::vector<Verdict> own(checks.size());
    const auto run = [&](std::size_t i) {
        ReferenceAnswers known;
        const auto found = endless.find(codeOf(*checks[i]));
        CheckResult first =
            found == endless.end()
                ? runOn(*checks[i], ownVariant(group), known)
                : withVerdict(*checks[i], Verdict::Timeout,
                              fmt::format("Not run: {} does not end.", found->second));
        own[i] = first.verdict;
        results[i] = follow(*checks[i], group, std::move(first), known);
        checkDone();
    };
    const auto runAll = [&](const std::vector<std::size_t> &wanted) {
        parallelFor(wanted.size(), m_options.jobs, [&](std::size_t k) { run(wanted[k]); });
    };
    runAll(ahead);
    for (const std::size_t i : ahead) {
        if (own[i] == Verdict::Timeout)
            endless.emplace(codeOf(*checks[i]), checks[i]->id);
    }
    runAll(after);
    if (std::find(own.begin(), own.end(), Verdict::Timeout) != own.end())
        m_endless.insert(group.id);
    if (group.id == "warp")
        followWarps(group, checks, results);
    remember(group, results);
    return results;
}

} // namespace grader
