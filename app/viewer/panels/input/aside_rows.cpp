// Points that take no part in the run, by reason, in the panel Doctor: to show them, and to bring
// them back.
#include "document/piece_actions.h"
#include "paint/shapes.h"
#include "panels/widgets/screen_painter.h"
#include "session/session.h"

namespace se::view {

namespace {

void drawAsideGroup(const PanelContext& context, const AsidePoints& group) {
    const std::string name = nameOf(group);
    ImGui::PushID(name.c_str());
    const float em = context.em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ScreenPainter painter(context);
    drawShape(painter, {at.x + 0.5F * em, at.y + 0.5F * ImGui::GetTextLineHeight()}, 0.7F * em,
              Shape::Plus, painter.ink(&Palette::unused));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.2F * em);
    wrappedText(withS(group.count, "point") + " " + reasonText(group) + ".");
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.2F * em);
    if (smallButton(context, "Show", "show " + name, "Frame these points in the view"))
        showAside(context.commands, group);
    const std::string_view back = returnText(group);
    if (!back.empty()) {
        ImGui::SameLine();
        if (smallButton(context, "Bring back", "return " + name, std::string(back)))
            bringBack(context.commands, group);
    }
    ImGui::PopID();
}

}  // namespace

void drawAside(const PanelContext& context) {
    const std::vector<AsidePoints>& groups = context.session().model().aside;
    if (groups.empty()) return;
    textIn(context.fonts.strong, "Not in the run");
    for (const AsidePoints& group : groups) drawAsideGroup(context, group);
    ImGui::Spacing();
    ImGui::Separator();
}

}  // namespace se::view
