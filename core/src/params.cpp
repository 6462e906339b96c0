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
};

constexpr std::array<std::string_view, 2> kSetNames{"paper", "printed"};

}  // namespace

std::span<const RuleSwitch> ruleSwitches() { return kSwitches; }

std::optional<Params> paramsByName(std::string_view name) {
    if (name == "paper") return Params{};
    if (name != "printed") return std::nullopt;
    Params printed;
    for (const RuleSwitch& rule : kSwitches) printed.rules.*rule.member = false;
    printed.dropOpposingNormals = false;
    return printed;
}

std::span<const std::string_view> paramSetNames() { return kSetNames; }

}  // namespace se
