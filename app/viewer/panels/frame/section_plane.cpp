// The plane of the panel Section, marked in the view while the panel is open: where it cuts the
// tangent plane, and the normal, named at the end that the panel has on the left: the tested point
// is on the right.
#include <algorithm>
#include <utility>

#include "panel_state/side_panels.h"
#include "panels/widgets/screen_painter.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// Length of the normal, as a share of the reach.
constexpr double kNormalShare = 0.5;
constexpr float kPlaneDash = 0.5F;

void dashedLine(ScreenPainter& painter, glm::vec2 from, glm::vec2 to, const Ink& ink, float dash) {
    const float length = glm::distance(from, to);
    if (length <= 0.0F) return;
    const glm::vec2 way = (to - from) / length;
    for (float done = 0.0F; done < length; done += 2.0F * dash)
        painter.line(from + done * way, from + std::min(done + dash, length) * way, ink);
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
    ScreenPainter painter(context);
    const float width = painter.px(0.1F);
    const Ink rim = painter.ink(&Palette::background, 0.7F).line(3.0F * width);
    const Ink ink = painter.ink(&Palette::text);
    for (const auto& [from, to] : {std::pair{*left, *right}, {*foot, *tip}}) {
        dashedLine(painter, from, to, rim, kPlaneDash * em);
        dashedLine(painter, from, to, ink.line(width), kPlaneDash * em);
    }
    const Type type{0.84F * em};
    const Rect& view = context.rects.view;
    const glm::vec2 room = painter.textSize("section", type) + glm::vec2(0.4F * em, 0.0F);
    const glm::vec2 corner =
        glm::clamp(*left - glm::vec2(0.2F * em + room.x, 0.4F * em), view.min, view.max() - room);
    painter.box({corner, room}, painter.ink(&Palette::background, 0.75F), 0.15F * em);
    painter.text({corner.x + 0.2F * em, corner.y}, "section", ink, type);
}

}  // namespace se::view
