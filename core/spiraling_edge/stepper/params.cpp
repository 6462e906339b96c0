#include "spiraling_edge/stepper/params.h"

#include <array>

#include "spiraling_edge/stepper/rule_settings.h"

namespace se {
namespace {

/// A named set of rules.
struct ParamSet {
    std::string_view name;
    Params (*make)();
};

Params printed() {
    Params params;
    for (const RuleSetting& rule : ruleSettings()) {
        if (rule.printed) rule.set(params, *rule.printed);
    }
    return params;
}

Params corrected() {
    Params params;
    RobustRules& r = params.robust;
    r.tangent = r.unblocked = r.stepBack = r.wallsDone = true;
    params.setStraysAside = true;
    return params;
}

Params robust() {
    Params params = corrected();
    RobustRules& r = params.robust;
    r.bothWalls = r.guard = r.gap = r.noPillow = r.noCross = r.noFold = r.noMeet = r.noLayer =
        r.rim = true;
    r.delay = r.shelve = r.fill = r.dropPatches = r.reinsert = r.closeHoles = r.flip = r.remesh =
        params.setNoiseAside = true;
    params.opposingCosine = kSheetsCosine;  // right-angled edges stay joined
    return params;
}

constexpr std::array kSets{
    ParamSet{"paper", [] { return Params{}; }},
    ParamSet{"printed", printed},
    ParamSet{"corrected", corrected},
    ParamSet{"robust", robust},
};

constexpr auto kSetNames = [] {
    std::array<std::string_view, kSets.size()> names;
    for (std::size_t i = 0; i < kSets.size(); ++i) names[i] = kSets[i].name;
    return names;
}();

}  // namespace

std::optional<Params> paramsByName(std::string_view name) {
    for (const ParamSet& set : kSets) {
        if (set.name == name) return set.make();
    }
    return std::nullopt;
}

std::span<const std::string_view> paramSetNames() { return kSetNames; }

}  // namespace se
