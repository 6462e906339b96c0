#include "spiraling_edge/spec/run_spec.h"

#include <algorithm>
#include <utility>

#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/spec_fields.h"

namespace se {
Params ruleParams(const RunSpec& spec) {
    Params params = paramsByName(spec.rules).value_or(Params{});
    for (const RuleValue& each : spec.choices) applyRuleValues({&each, 1}, params);
    return params;
}

Result<Params> paramsOf(const RunSpec& spec) {
    std::optional<Params> params = paramsByName(spec.rules);
    if (!params) return Error{"There is no rule set " + inQuotes(spec.rules) + "."};
    if (const Status known = applyRuleValues(spec.choices, *params); !known) return known.error();
    params->whatIf = spec.whatIf;
    params->start = spec.start;
    if (spec.start.empty() && isScene(spec.source))
        params->start = startOfScene(spec.source.substr(kScenePrefix.size()));
    return *params;
}

RunSpec specOf(const Params& params) {
    RunSpec spec;
    spec.choices = differingRules(params, *paramsByName(spec.rules));
    spec.whatIf = params.whatIf;
    spec.start = params.start;
    return spec;
}

RunSpec withFixesAsOptions(RunSpec spec) {
    const bool ownNormals = spec.normals != NormalSource::AsGiven;
    const bool ownLists = spec.neighbors.recompute;
    for (const std::string& name : std::exchange(spec.fixes, {})) {
        const DoctorCheck* check = findDoctorCheck(name);
        const SpecChange change = changeOf(check != nullptr ? check->fix : Fix::None);
        const bool hasOwn = (ownNormals && !textOf(change, "normals").empty()) ||
                            (ownLists && !textOf(change, "neighbors").empty());
        if (!hasOwn) spec = changed(std::move(spec), change);
    }
    return spec;
}

bool findsRims(const Params& params, const RunSpec& spec, const PointFile& file) {
    const bool given = spec.walls.from == WallChoice::From::File &&
                       std::any_of(file.type.begin(), file.type.end(), isRimPoint);
    return params.robust.rim && !given;
}

Result<PrepareOptions> prepareOptionsOf(const RunSpec& spec, const Params& params,
                                        const PointFile& file) {
    if (spec.scanner && file.hasNormals() && spec.normals == NormalSource::AsGiven) {
        return Error{
            "The points have normals; only flipped or derived ones can face a scanner "
            "(--orient, --derive-normals)."};
    }
    PrepareOptions options;
    options.neighbors = spec.neighbors;
    options.neighbors.dropOpposingNormals = params.dropOpposingNormals;
    options.neighbors.opposingCosine = params.opposingCosine;
    options.normals = spec.normals;
    options.scanner = spec.scanner;
    if (spec.walls.from == WallChoice::From::Around) options.walls = boxAround(file.position);
    if (spec.walls.from == WallChoice::From::Box) options.walls = spec.walls.box;
    options.rim = spec.rim || findsRims(params, spec, file);
    options.setNoiseAside = params.setNoiseAside;
    options.setStraysAside = params.setStraysAside;
    return options;
}

bool preparesAlike(const Params& a, const Params& b) {
    return a.dropOpposingNormals == b.dropOpposingNormals && a.opposingCosine == b.opposingCosine &&
           a.setNoiseAside == b.setNoiseAside && a.setStraysAside == b.setStraysAside &&
           a.robust.rim == b.robust.rim;
}

RunSpec withRulesOf(RunSpec spec, const RunSpec& rules) {
    spec.rules = rules.rules;
    spec.choices = rules.choices;
    spec.whatIf = rules.whatIf;
    return spec;
}

RunSpec withSet(RunSpec spec, std::string_view set) {
    spec.rules = set;
    spec.choices.clear();
    return spec;
}

RunSpec withRule(RunSpec spec, std::string_view name, double value) {
    Params params = ruleParams(spec);
    if (const RuleSetting* setting = findRuleSetting(name)) setting->set(params, value);
    spec.choices = differingRules(params, paramsByName(spec.rules).value_or(Params{}));
    return spec;
}

double valueOf(const RunSpec& spec, const RuleSetting& setting) {
    return setting.get(ruleParams(spec));
}

double usualValueOf(const RunSpec& spec, const RuleSetting& setting) {
    return setting.get(paramsByName(spec.rules).value_or(Params{}));
}

}  // namespace se
