// The plane of the panel Section, marked in the view while the panel is open: where it cuts the
// tangent plane, and the normal, named at the end that the panel has on the left: the tested point
// is on the right.
#include <algorithm>
#include <utility>

#include "panel_state/side_panels.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// Length of the normal, as a share of the reach.
constexpr double kNormalShare = 0.5;
constexpr float kPlaneDash = 0.5F;

void dashedLine(ImDrawList* list, glm::vec2 from, glm::vec2 to, ImU32 color, float dash,
                float width) {
    const float length = glm::distance(from, to);
    if (length <= 0.0F) return;
    const glm::vec2 way = (to - from) / length;
    for (float done = 0.0F; done < length; done += 2.0F * dash)
        list->AddLine(toVec2(from + done * way), toVec2(from + std::min(done + dash, length) * way),
                      color, width);
}

}  // namespace

void drawSectionPlane(const PanelContext& context) {
    const SectionPanel& panel = context.state<SectionPanel>();
    const NormalSection& section = panel.made;
    const bool shown = ImGui::GetFrameCount() - panel.shownIn <= 1;
    if (context.beside || !shown || section.empty()) return;
    const Model& model = context.session().shown();
    const ScreenProjection screen(context);
    const Vec3& pivot = model.points.position[section.pivot];
    const auto at = [&](const Vec3& offset) { return screen.at(model.toView(pivot + offset)); };
    const auto left = at(-section.reach * section.along);
    const auto right = at(section.reach * section.along);
    const auto foot = at(Vec3(0.0));
    const auto tip = at(kNormalShare * section.reach * section.normal);
    if (!left || !right || !foot || !tip) return;
    const float em = context.em;
    const float width = std::max(1.0F, 0.1F * em);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 rim = toU32(context.palette.background.withAlpha(0.7F));
    const ImU32 ink = toU32(context.palette.text);
    for (const auto& [from, to] : {std::pair{*left, *right}, {*foot, *tip}}) {
        dashedLine(list, from, to, rim, kPlaneDash * em, 3.0F * width);
        dashedLine(list, from, to, ink, kPlaneDash * em, width);
    }
    const char* name = "section";
    const float size = 0.84F * em;
    const ImVec2 extent = context.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, name);
    const Rect& view = context.rects.view;
    const glm::vec2 room(extent.x + 0.4F * em, extent.y);
    const glm::vec2 corner =
        glm::clamp(*left - glm::vec2(0.2F * em + room.x, 0.4F * em), view.min, view.max() - room);
    fill(list, {corner, room}, context.palette.background.withAlpha(0.75F), 0.15F * em);
    list->AddText(context.fonts.text, size, {corner.x + 0.2F * em, corner.y}, ink, name);
}

}  // namespace se::view
