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
            if (verdictOf(*event)) color = verdictColor(context, *event);
        } else if (session.ready()) {
            sentence = "Nothing has been done yet: all points are UNUSED.";
        }
        const Rect& area = context.layout.narration;
        ImDrawList* list = ImGui::GetWindowDrawList();
        list->PushClipRect(toVec2(area.min), toVec2(area.max()));
        list->AddRectFilled(toVec2(area.min), {area.min.x + 0.3F * context.em, area.max().y},
                            toU32(color));
        list->PopClipRect();
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5F * context.em);
        ImGui::PushFont(context.fonts.large);
        const float width = ImGui::GetContentRegionAvail().x;
        const float left = ImGui::GetCursorPosX();
        for (const std::string& line : wrapped(sentence, width)) {
            ImGui::SetCursorPosX(left);
            ImGui::TextUnformatted(line.c_str());
        }
        ImGui::PopFont();
    }
    ImGui::End();
}

}  // namespace se::view
