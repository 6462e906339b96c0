#include "spiraling_edge/params.h"

#include <algorithm>
#include <array>

namespace se {
namespace {

constexpr std::array kSwitches{
    RuleSwitch{"limitsfirst", "6.1", "start and end advance before other neighbors are looked at",
               &Rules::limitsFirst},
    RuleSwitch{"freesector", "6.1", "the reciprocal test looks at the free side of the ring",
               &Rules::freeSector},
    RuleSwitch{"realhole", "6.2", "a hole of three has three mesh edges and under 180 degrees",
               &Rules::realHole},
    RuleSwitch{"closetwo", "6.5", "a ring of two finished edges is closed", &Rules::closeTwo},
    RuleSwitch{"opensteps", "7", "ring steps that are no mesh edges are known as open",
               &Rules::openSteps},
    RuleSwitch{"tangent", "6.1", "angles are measured in the tangent plane of the pivot",
               &Rules::tangent},
    RuleSwitch{"unblocked", "6.1", "start and end do not pass over an UNUSED neighbor",
               &Rules::unblocked},
    RuleSwitch{"stepback", "6.3", "after a removal the point before it is looked at again",
               &Rules::stepBack},
    RuleSwitch{"wallsdone", "7", "boundary points complete along their walls are no candidates",
               &Rules::wallsDone},
    RuleSwitch{"bothwalls", "7.2", "no third point beside a boundary point open at its other side",
               &Rules::bothWalls},
    RuleSwitch{"guard", "6.4", "no directed edge twice: always an oriented manifold",
               &Rules::guard},
    RuleSwitch{"gap", "6.4", "no fan with a gap of 180 degrees or more", &Rules::gap},
    RuleSwitch{"nopillow", "6.4", "no second triangle on the same three points", &Rules::noPillow},
    RuleSwitch{"nocross", "6.4", "no new edge across a ring edge nearby", &Rules::noCross},
    RuleSwitch{"nofold", "6.4", "no triangle against its normals or folded onto another",
               &Rules::noFold},
    RuleSwitch{"nomeet", "6.4", "no triangle that meets a finished one nearby", &Rules::noMeet},
    RuleSwitch{"rim", "7", "the surface ends where neighbors leave a wide gap", &Rules::rim},
    RuleSwitch{"delay", "6.5", "fans with steep triangles wait for a circuit", &Rules::delay},
    RuleSwitch{"fill", "6.5", "rings with interior points are closed by ears", &Rules::fill},
    RuleSwitch{"reinsert", "4", "stranded points go into the triangle they lie over",
               &Rules::reinsert},
    RuleSwitch{"flip", "6.3", "edges that are better the other way round are flipped",
               &Rules::flip},
    RuleSwitch{"reseat", "4", "points at flipped triangles are taken out where that mends",
               &Rules::reseat},
};

/// A named set of rules.
struct ParamSet {
    std::string_view name;
    Params (*make)();
};

Params printed() {
    Params params;
    for (const RuleSwitch& rule : kSwitches) params.rules.*rule.member = false;
    params.dropOpposingNormals = false;
    return params;
}

Params corrected() {
    Params params;
    Rules& r = params.rules;
    r.tangent = r.unblocked = r.stepBack = r.wallsDone = true;
    return params;
}

Params robust() {
    Params params = corrected();
    Rules& r = params.rules;
    r.bothWalls = r.guard = r.gap = r.noPillow = r.noCross = r.noFold = r.noMeet = r.rim = true;
    r.delay = r.fill = r.reinsert = r.flip = r.reseat = true;
    params.setNoiseAside = true;
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

std::span<const RuleSwitch> ruleSwitches() { return kSwitches; }

std::optional<Params> paramsByName(std::string_view name) {
    for (const ParamSet& set : kSets) {
        if (set.name == name) return set.make();
    }
    return std::nullopt;
}

std::span<const std::string_view> paramSetNames() { return kSetNames; }

}  // namespace se
