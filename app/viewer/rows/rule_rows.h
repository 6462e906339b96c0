/// The rows of the Rules panel. Plain values, no ImGui.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

struct RuleRow {
    const RuleSetting* setting;
    double value;
    double usual;  ///< Value in the rule set.
    bool differs() const { return value != usual; }
};

/// The rows of one section, or of the rules beyond the paper.
struct RuleGroup {
    std::string title;  ///< "6.3 Removing neighbors"
    std::vector<RuleRow> rows;
};

/// The rules that have every word of `filter` in name, section, summary, value or the paper's
/// sentence, in any case, or "differs" for those that differ from their set.
std::vector<RuleGroup> ruleGroups(const RunSpec& rules, std::string_view filter);
/// Number of rules that differ from their set.
std::size_t differingCount(const RunSpec& rules);
/// The effect of a rule, of a switch when on.
std::string ruleSentence(const RuleRow& row);
/// Text of the tooltip: effect, possible values, and the paper's sentence.
std::string ruleHelp(const RuleRow& row);

}  // namespace se::view
