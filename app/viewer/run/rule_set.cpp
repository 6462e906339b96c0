#include "rule_set.h"

#include <algorithm>

#include "model.h"
#include "spiraling_edge/explain/run_settings.h"

namespace se::view {

namespace {

/// Unknown rules are ignored here: they were refused where they were entered.
Params paramsOf(const RuleSet& rules) {
    Params params = paramsByName(rules.name).value_or(Params{});
    for (const RuleValue& each : rules.choices) applyRuleValues({&each, 1}, params);
    return params;
}

}  // namespace

RuleSet rulesOf(const InputSpec& spec) { return {spec.rules, spec.choices, spec.whatIf}; }

InputSpec withRules(InputSpec spec, const RuleSet& rules) {
    // Otherwise the option would override the rule.
    const auto chosen = [&](std::string_view name) {
        return std::any_of(rules.choices.begin(), rules.choices.end(),
                           [&](const RuleValue& each) { return each.name == name; });
    };
    if (chosen("opposing")) spec.keepOpposing = false;
    if (chosen("noise")) spec.keepNoise = false;
    if (chosen("strays")) spec.keepStrays = false;
    spec.rules = rules.name;
    spec.choices = rules.choices;
    spec.whatIf = rules.whatIf;
    return spec;
}

Result<Params> paramsOf(const InputSpec& spec) {
    RunSettings settings{spec.rules,        spec.choices,   spec.whatIf,
                         spec.keepOpposing, spec.keepNoise, spec.keepStrays};
    settings.start = spec.start;
    if (settings.start.empty() && isScene(spec.source))
        settings.start = startOfScene(spec.source.substr(kScenePrefix.size()));
    return se::paramsOf(settings);
}

RuleSet withRule(const RuleSet& rules, std::string_view name, double value) {
    RuleSet made = rules;
    Params params = paramsOf(rules);
    if (const RuleSetting* setting = findRuleSetting(name)) setting->set(params, value);
    made.choices = differingRules(params, paramsByName(rules.name).value_or(Params{}));
    return made;
}

double valueOf(const RuleSet& rules, const RuleSetting& setting) {
    return setting.get(paramsOf(rules));
}

double usualValueOf(const RuleSet& rules, const RuleSetting& setting) {
    return setting.get(paramsByName(rules.name).value_or(Params{}));
}

std::string describeChange(const RuleSet& from, const RuleSet& to) {
    if (from.whatIf != to.whatIf) return "what-if";
    if (from.name != to.name) return "rules " + to.name;
    const std::vector<RuleValue> changed = differingRules(paramsOf(to), paramsOf(from));
    return changed.size() == 1 ? "rule " + changed.front().name : "rules";
}

}  // namespace se::view
