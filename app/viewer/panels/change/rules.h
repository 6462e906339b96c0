/// All rules as switches, choices and numbers: the list of the panel Rules, and of the other run in
/// the layout Compare.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "panels/panel.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

struct RuleListFields {
    std::array<char, 64>& filter;
    std::string prefix;  ///< Prefix of the item names for test scripts: "", "compare ".
};

/// Choice of the rule set; empty if nothing changed in this frame.
std::optional<RunSpec> drawRuleSets(const PanelContext& context, const RunSpec& rules,
                                    const RuleListFields& place);
/// The filter, and all rules that match it.
std::optional<RunSpec> drawRuleList(const PanelContext& context, const RunSpec& rules,
                                    const RuleListFields& place);

}  // namespace se::view
