/// All rules as switches: a change re-runs the input at once.
#include <imgui.h>

#include "panel_state/ui_requests.h"
#include "panel_state/ui_state.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "rows/rule_rows.h"
#include "rule_list.h"
#include "session/session.h"

namespace se::view {

void drawRules(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) {
        ImGui::TextDisabled("Nothing is open.");
        return;
    }
    const RuleSet rules = session.input().rules();
    const std::size_t count = differingCount(rules);
    heading(context, "Rules",
            session.input().isRerunning() ? "re-running ..."
            : count == 0                  ? "values of the set"
                         : std::to_string(count) + (count == 1 ? " differs" : " differ"));
    const RuleListFields place{context.ui().ruleFilter, ""};
    std::optional<RuleSet> chosen = drawRuleSets(context, rules, place);
    if (auto single = drawRuleList(context, rules, place)) chosen = std::move(single);
    if (chosen) context.requests().rules = *chosen;
}

}  // namespace se::view
