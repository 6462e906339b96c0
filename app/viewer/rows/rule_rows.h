/// The rows of the Rules panel. Plain values, no ImGui.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "run/rule_set.h"

namespace se::view {

struct RuleRow {
    const RuleSetting* setting;
    double value;
    double usual;  ///< What the set of rules says.
    bool differs() const { return value != usual; }
};

/// The rows of one section, or of the rules beyond the paper.
struct RuleGroup {
    std::string title;  ///< "6.3 Removing neighbors"
    std::vector<RuleRow> rows;
};

/// The rules that have every word of `filter` in name, section, summary, value or the paper's
/// sentence, whatever the case, or "differs" for those that are not as their set has them.
std::vector<RuleGroup> ruleGroups(const RuleSet& rules, std::string_view filter);
/// How many rules are not as their set has them.
std::size_t differingCount(const RuleSet& rules);
/// What stands in the tooltip: what it does, what can be chosen, and the paper's sentence.
std::string ruleHelp(const RuleRow& row);

}  // namespace se::view
