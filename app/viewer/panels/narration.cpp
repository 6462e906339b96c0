#include "panel.h"
#include "widgets.h"

namespace se::view {

void drawNarration(const PanelContext& context) {
    const Session& session = context.session();
    if (beginRegion("##narration", context.layout.narration)) {
        const Event* event = session.event();
        std::string sentence;
        Color color = context.palette.accent;
        if (!session.message().empty()) {
            sentence = session.message();
        } else if (event != nullptr) {
            sentence = describe(*event);
            color = verdictColor(context, *event);
        } else if (session.ready()) {
            sentence = "Nothing has been done yet: all points are UNUSED.";
        }
        const Rect& area = context.layout.narration;
        ImGui::GetWindowDrawList()->AddRectFilled(
            toVec2(area.min), {area.min.x + 0.3F * context.em, area.max().y}, toU32(color));
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5F * context.em);
        ImGui::PushFont(context.fonts.large);
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(sentence.c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }
    ImGui::End();
}

}  // namespace se::view
