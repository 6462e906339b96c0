#include <cmath>
#include <string>

#include "panels/widgets/widgets.h"
#include "scene/camera.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// The disc with the letter, and the arrow from its center to the tip, in em.
constexpr float kDisc = 0.85F;
constexpr float kTip = 1.75F;
constexpr float kInset = 2.0F;

}  // namespace

std::optional<PivotArrow> offerPivotArrow(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready() || session.picture().pivot == kNone) return std::nullopt;
    const Rect& view = context.rects.view;
    const Index pivot = session.picture().pivot;
    const auto arrow = edgeArrow(context.camera().matrices(view.size.x / view.size.y),
                                 session.shown().place[pivot], view.size, kInset * context.em);
    if (!arrow) return std::nullopt;
    const glm::vec2 half(kTip * context.em);
    PivotArrow found{*arrow, {view.min + arrow->at - half, 2.0F * half}};
    ImGui::SetCursorScreenPos(toVec2(found.rect.min));
    if (ImGui::InvisibleButton("##pivotArrow", toVec2(found.rect.size))) {
        context.run("view.pivot");
    }
    found.hovered = ImGui::IsItemHovered();
    tooltip("The pivot, p " + std::to_string(pivot) +
            ", is outside of the view.\nClick to center it.");
    context.where()["pivot arrow"] = found.rect;
    return found;
}

void drawPivotArrow(const PanelContext& context, const PivotArrow& arrow) {
    const float em = context.em;
    const Palette& colors = context.palette;
    const glm::vec2 at = arrow.rect.min + 0.5F * arrow.rect.size;
    const glm::vec2 way = arrow.arrow.way;
    const glm::vec2 across(-way.y, way.x);
    const ImU32 color = toU32(colors.pivot);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const glm::vec2 neck = at + kDisc * 0.55F * em * way;
    list->AddTriangleFilled(toVec2(at + kTip * em * way), toVec2(neck + 0.8F * em * across),
                            toVec2(neck - 0.8F * em * across), color);
    list->AddCircleFilled(toVec2(at), kDisc * em,
                          toU32(arrow.hovered ? colors.panelRaised : colors.background), 32);
    list->AddCircle(toVec2(at), kDisc * em, color, 32, std::max(1.5F, 0.14F * em));
    const ImVec2 extent = context.fonts.strong->CalcTextSizeA(em, 1e9F, 0.0F, "p");
    list->AddText(context.fonts.strong, em,
                  {std::round(at.x - 0.5F * extent.x), std::round(at.y - 0.56F * extent.y)}, color,
                  "p");
}

}  // namespace se::view
