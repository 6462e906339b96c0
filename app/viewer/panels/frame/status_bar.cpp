// The status bar: address, counts, and the most used keys.
#include <algorithm>
#include <vector>

#include "commands/alert_actions.h"
#include "layout/bars.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"
#include "spiraling_edge/run/status_list.h"

namespace se::view {

namespace {

/// Minimum room of the address, so that the next parts do not move.
constexpr float kAddressWidth = 10.3F;
constexpr float kPartGap = 1.2F;

/// The most important first.
std::vector<std::string> partsOf(const PanelContext& context) {
    const Session& session = context.session();
    const DecisionState& picture = session.picture();
    std::vector<std::string> parts;
    if (!session.record().events.empty()) {
        parts.push_back("event " + std::to_string(session.cursor() + 1) + "/" +
                        std::to_string(session.record().events.size()));
    }
    parts.push_back("triangles " +
                    grouped(picture.finishedTriangles + picture.newTriangles.size()));
    const AlertSearch& alerts = session.alerts().search();
    if (alerts.done()) parts.push_back(verdictText(alerts));
    parts.push_back("unused " + grouped(context.counts.unused) + "   used " +
                    grouped(context.counts.used) + "   done " + grouped(context.counts.done));
    return parts;
}

/// The most used keys, with the user's changes; those without a key are left out.
std::string keysText(const PanelContext& context) {
    struct Hint {
        const char* command;
        const char* what;
    };
    std::string text;
    for (const Hint& each : {Hint{"step.event.next", "sub-step"}, Hint{"step.pivot.next", "pivot"},
                             Hint{"run.play", "play"}, Hint{"help.keys", "keys"}}) {
        const std::string key = context.key(each.command);
        if (key.empty()) continue;
        text += (text.empty() ? "" : "   ") + key + " " + each.what;
    }
    return text;
}

}  // namespace

void drawStatusBar(const PanelContext& context) {
    const float em = context.em;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.7F * em, 0.3F * em});
    const bool open = beginRegion("##status", context.rects.status, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    if (open) {
        const float total = ImGui::GetContentRegionAvail().x;
        const float left = ImGui::GetCursorPosX();
        textIn(context.fonts.mono, addressText(context.session()));
        const float width = ImGui::GetItemRectSize().x;
        std::vector<std::string> parts;
        if (context.session().ready()) parts = partsOf(context);
        const std::string keys = keysText(context);
        std::vector<float> widths;
        widths.reserve(parts.size() + 1);
        for (const std::string& part : parts) widths.push_back(ImGui::CalcTextSize(part.c_str()).x);
        widths.push_back(ImGui::CalcTextSize(keys.c_str()).x);
        float x = left + std::max(kAddressWidth * em, width + kPartGap * em);
        const std::size_t fits = fittingParts(left + total - x, widths, kPartGap * em);
        for (std::size_t i = 0; i < std::min(fits, parts.size()); ++i) {
            ImGui::SameLine(x);
            ImGui::TextUnformatted(parts[i].c_str());
            nameItem(context, "status " + std::to_string(i + 1));
            x += widths[i] + kPartGap * em;
        }
        if (fits > parts.size()) {
            ImGui::SameLine(left + total - widths.back());
            ImGui::TextDisabled("%s", keys.c_str());
        }
    }
    ImGui::End();
}

}  // namespace se::view
