// The best settings that were tried for the open input, with the outcome of their run.
#include "commands/alert_actions.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

void drawBestTrial(const PanelContext& context, const std::string& name) {
    const TrialJob& job = context.session().trials();
    if (const Trial* best = job.best()) {
        wrappedText("Other settings were tried: " + wordsOf(best->change) + ". Now " +
                    headlineOf(job.trials().tried.front().verdict) + "; then " +
                    headlineOf(best->verdict) + ".");
        if (job.ended()) {
            if (smallButton(context, "Fix", name, fixText(job))) fixByTrials(context.commands);
            context.state<VerdictCard>().pointedAt |= ImGui::IsItemHovered();
        }
        ImGui::Spacing();
    } else if (job.busy()) {
        dimText("Other settings are being tried: see the card over the mesh.");
    } else if (job.ended() && job.complaint().empty() && job.trials().tried.size() > 1) {
        dimText(noneBetterText(job.trials()));
    }
}

}  // namespace se::view
