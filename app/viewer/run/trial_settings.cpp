#include "trial_settings.h"

#include "rule_set.h"

namespace se::view {

InputSpec withFixOptions(InputSpec spec) {
    for (const std::string& name : spec.fixes) {
        const DoctorCheck* check = findDoctorCheck(name);
        if (check == nullptr) continue;
        if (check->fix == Fix::Orient) spec.normals = NormalSource::Oriented;
        if (check->fix == Fix::Symmetric) spec.neighbors.symmetric = true;
        if (check->fix == Fix::Walls) spec.walls = {WallChoice::From::Around, {}};
        if (check->fix == Fix::Rim) spec.rim = true;
        if (check->fix != Fix::NewLists) continue;
        spec.neighbors.reach = KNearest{};
        spec.neighbors.recompute = true;
    }
    return spec;
}

RunSettings settingsOf(const InputSpec& spec, const PointFile& given) {
    RunSettings settings;
    settings.rules = spec.rules;
    settings.choices = spec.choices;
    settings.whatIf = spec.whatIf;
    settings.keepOpposing = spec.keepOpposing;
    settings.keepNoise = spec.keepNoise;
    settings.prepare = prepareOptions(withFixOptions(spec), {}, given);
    return settings;
}

InputSpec withChange(InputSpec spec, const SettingsChange& change) {
    RuleSet rules = rulesOf(spec);
    if (!change.rules.empty()) rules.name = change.rules;
    if (!change.ruleOff.empty()) rules = withRule(rules, change.ruleOff, 0.0);
    spec = withRules(std::move(spec), rules);
    if (change.nearest > 0) {
        spec.neighbors.reach = KNearest{change.nearest};
        spec.neighbors.recompute = true;
    }
    spec.normals = change.normals.value_or(spec.normals);
    spec.neighbors.symmetric = spec.neighbors.symmetric || change.symmetric;
    spec.rim = spec.rim || change.rim;
    if (!change.drop.empty()) spec.fixes.emplace_back(change.drop);
    return spec;
}

}  // namespace se::view
