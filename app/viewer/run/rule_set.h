/// How a run decides: by which rules, and what a person lets happen besides. Part of an input's
/// specification; to change it the run is begun anew.
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
    std::vector<WhatIf> whatIf;      ///< In the order in which they were said.
    friend bool operator==(const RuleSet&, const RuleSet&) = default;
};

/// Of an input, and back into it.
RuleSet rulesOf(const InputSpec& spec);
InputSpec withRules(InputSpec spec, const RuleSet& rules);

/// Fails with a sentence if there is no such set or rule.
Result<Params> paramsOf(const InputSpec& spec);

/// `rules` with one rule set, for the Rules panel and whoever knows what would help:
/// `ui.requests.rules = withRule(rulesOf(session.spec()), "fill", 1.0)`. A rule that is as its set
/// has it is no choice any more. Requires that there is such a rule.
RuleSet withRule(const RuleSet& rules, std::string_view name, double value);
/// The value of a rule: the choice, or what its set says. Requires that there is such a rule.
double valueOf(const RuleSet& rules, const RuleSetting& setting);
/// What its set alone says.
double usualValueOf(const RuleSet& rules, const RuleSetting& setting);

/// §6.3: the gap above which a neighbor is kept.
inline double gapLimitDegrees(const Params& params) {
    static const RuleSetting* const setting = findRuleSetting("maxgap");
    return setting->get(params);
}

/// What differs, in words: "rule tie", "rules", "what-if".
std::string describeChange(const RuleSet& from, const RuleSet& to);

}  // namespace se::view
