#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

std::string figures(const PanelContext& context) {
    const Session& session = context.session();
    const Picture& picture = session.picture();
    std::string text;
    if (!session.record().events.empty()) {
        text += "event " + std::to_string(session.cursor() + 1) + "/" +
                std::to_string(session.record().events.size()) + "     ";
    }
    text += "triangles " + grouped(picture.finishedTriangles + picture.newTriangles.size());
    text += "     unused " + grouped(context.counts.unused);
    text += "   used " + grouped(context.counts.used);
    text += "   done " + grouped(context.counts.done);
    return text;
}

}  // namespace

void drawStatusBar(const PanelContext& context) {
    const float em = context.em;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.7F * em, 0.3F * em});
    const bool open = beginRegion("##status", context.layout.status, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    if (open) {
        ImGui::PushFont(context.fonts.mono);
        ImGui::TextUnformatted(addressText(context.session()).c_str());
        ImGui::PopFont();
        const std::string keys = "F11 sub-step   F10 pivot   Space play   F1 keys";
        const float keysWidth = ImGui::CalcTextSize(keys.c_str()).x;
        const float total = context.layout.status.size.x;
        if (context.session().ready()) {
            ImGui::SameLine(11.0F * em);
            const bool both = total > keysWidth + 46.0F * em;
            const float room = total - 12.0F * em - (both ? keysWidth : 0.0F);
            ImGui::TextUnformatted(fitted(figures(context), room).c_str());
        }
        if (total > keysWidth + 46.0F * em) {
            ImGui::SameLine(total - keysWidth - 0.7F * em);
            ImGui::TextDisabled("%s", keys.c_str());
        }
    }
    ImGui::End();
}

}  // namespace se::view
