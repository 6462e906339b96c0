#include "trial_settings.h"

#include <cassert>

#include "rule_set.h"
#include "strings.h"

namespace se::view {

RunSettings settingsOf(const InputSpec& spec, const PointFile& given) {
    RunSettings settings;
    settings.rules = spec.rules;
    settings.choices = spec.choices;
    settings.whatIf = spec.whatIf;
    settings.keepOpposing = spec.keepOpposing;
    settings.keepNoise = spec.keepNoise;
    settings.keepStrays = spec.keepStrays;
    settings.prepare = prepareOptions(withFixOptions(spec), {}, given);
    return settings;
}

InputSpec withChange(InputSpec spec, const SettingsChange& change) {
    RuleSet rules = rulesOf(spec);
    if (!change.rules.empty()) rules.name = change.rules;
    if (!change.ruleOff.empty()) rules = withRule(rules, change.ruleOff, 0.0);
    spec = withRules(std::move(spec), rules);
    spec.neighbors = changedLists(spec.neighbors, change);
    spec.normals = change.normals.value_or(spec.normals);
    spec.rim = spec.rim || change.rim;
    if (!change.drop.empty()) spec.fixes.emplace_back(change.drop);
    return spec;
}

std::string noneBetterText(const Trials& trials) {
    assert(!trials.tried.empty());
    const std::size_t changes = trials.tried.size() - 1;
    return "No better settings among " + grouped(changes) +
           (changes == 1 ? " change" : " changes") + " tried.";
}

}  // namespace se::view
