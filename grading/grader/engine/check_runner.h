// SPDX-License-Identifier: MIT
#pragma once

#include <grader/engine/engine.h>
#include <grader/engine/groups.h>
#include <grader/engine/reference_answers.h>

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace grader {

/// Runs the checks of one hand-in, group by group.
class CheckRunner {
public:
    /// \param referenceProbe  our own complete probe
    CheckRunner(const Sandbox &sandbox, const EngineOptions &options,
                std::filesystem::path referenceProbe, VariantBuilder &builder,
                std::string submissionDigest);

    /// Runs `checks`, all of one group, and remembers whether the group is at fault, for the groups
    /// that stand on it.
    std::vector<CheckResult> runGroup(const Group &group, const std::vector<const Check *> &checks,
                                      const std::function<void()> &checkDone);

    /// After all groups: an integrator that is right with our Scene only is excused where the
    /// checks of the choice of lights have failed, and charged where they have not.
    void settle(std::vector<CheckResult> &results) const;

    /// Forgets which groups were at fault. What was measured stays: the same check on the same
    /// variant is not run again.
    void startAnew();

    /// Whether a check of any group that was run has failed.
    bool foundFault() const { return !m_atFault.empty(); }

    /// Wall seconds that probes have run.
    double sampleSeconds() const { return m_sampleSeconds; }

private:
    CheckResult runOn(const Check &check, const Variant &variant, ReferenceAnswers &known);
    CheckResult measure(const Check &check, const Variant &variant, ReferenceAnswers &known);
    CheckResult follow(const Check &check, const Group &group, CheckResult first,
                       ReferenceAnswers &known);
    /// Runs what has failed again with ours for the other warps that have: what passes then is
    /// right, and calls one that is not. Of warps that call each other in a circle, which is right
    /// with ours for any of them, not all are excused: none by one that was excused by it.
    void followWarps(const Group &group, const std::vector<const Check *> &checks,
                     std::vector<CheckResult> &results);
    /// With what a failure of the group is followed through.
    /// \param excusable  something upstream is at fault, or holds up the program
    std::vector<VariantPlan> plansFor(const Group &group, bool excusable);
    /// Whether the group is at fault, and what its emitter returns.
    void remember(const Group &group, const std::vector<CheckResult> &results);
    const Variant &variant(const VariantPlan &plan, const Group &group);
    /// The hand-in as it is.
    const Variant &ownVariant(const Group &group);
    bool upstreamAtFault(const Group &group) const;

    const Sandbox &m_sandbox;
    const EngineOptions &m_options;
    std::filesystem::path m_referenceProbe;
    VariantBuilder &m_builder;
    std::string m_digest;
    std::map<std::string, Variant> m_variants;          ///< by group and plan name
    std::map<std::string, CheckResult> m_chosenWrongly; ///< with the hand-in's Scene, by check id
    std::map<std::string, CheckResult> m_measured;      ///< by check id and plan name
    std::mutex m_mutex;                                 ///< of the three maps
    std::set<std::string> m_atFault;                    ///< groups with a check that failed
    SampleConventions m_conventions;                    ///< of the emitters that were checked
    std::set<std::string> m_endless; ///< ids of groups with a check that ran into a time limit
    std::atomic<double> m_sampleSeconds{0};
};

} // namespace grader
