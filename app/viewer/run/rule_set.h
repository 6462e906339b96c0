/// The rules of a run, and the decisions that the user overrides. Part of an input's specification;
/// a change re-runs the input.
#pragma once

#include <string>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/rule_settings.h"

namespace se::view {

struct InputSpec;

struct RuleSet {
    std::string name = "paper";      ///< A name that paramsByName() knows.
    std::vector<RuleValue> choices;  ///< Single rules that differ from that set.
    std::vector<WhatIf> whatIf;      ///< In the order in which they were added.
    friend bool operator==(const RuleSet&, const RuleSet&) = default;
};

/// The rule set of an input, and an input with another rule set.
RuleSet rulesOf(const InputSpec& spec);
InputSpec withRules(InputSpec spec, const RuleSet& rules);

/// Fails with a sentence if there is no such set or rule.
Result<Params> paramsOf(const InputSpec& spec);

/// `rules` with one rule set, for the Rules panel and for callers that suggest a remedy:
/// `ui.requests.rules = withRule(rulesOf(session.input().spec()), "fill", 1.0)`. A value equal to
/// that of the set is no longer a choice; an unknown name changes nothing.
RuleSet withRule(const RuleSet& rules, std::string_view name, double value);
/// The value of a rule: the choice, or the value of its set.
double valueOf(const RuleSet& rules, const RuleSetting& setting);
/// The value of a rule in its set alone.
double usualValueOf(const RuleSet& rules, const RuleSetting& setting);

/// §6.3: the gap above which a neighbor is kept.
inline double gapLimitDegrees(const Params& params) {
    static const RuleSetting* const setting = findRuleSetting("maxgap");
    return setting->get(params);
}

/// Differences in words: "rule tie", "rules", "what-if".
std::string describeChange(const RuleSet& from, const RuleSet& to);

}  // namespace se::view
