/// The labels of the view.
#include <algorithm>

#include "panels/widgets/widgets.h"
#include "scene/draw_list.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

struct Print {
    ImFont* font;
    float size;
};

Print printOf(const PanelContext& context, const Label& label) {
    if (label.strong) return {context.fonts.strong, context.em};
    return {context.fonts.text, 0.88F * context.em};
}

LabelRank rankOf(const Label& label) {
    return label.essential ? LabelRank::Essential
           : label.strong  ? LabelRank::Strong
                           : LabelRank::Minor;
}

void drawPlate(const PanelContext& context, const Label& label, const Rect& plate) {
    const float em = context.em;
    const Print print = printOf(context, label);
    ImDrawList* list = ImGui::GetWindowDrawList();
    fill(list, plate, context.palette.background.withAlpha(0.78F), 0.2F * em);
    list->AddText(print.font, print.size, {plate.min.x + 0.22F * em, plate.min.y + 0.02F * em},
                  toU32(label.color), label.text.c_str());
}

}  // namespace

void drawLabels(const PanelContext& context, std::span<const Rect> taken) {
    const std::vector<Label>& labels = context.drawList.labels;
    if (labels.empty()) return;
    const ScreenProjection projection(context);
    const float em = context.em;
    std::vector<const Label*> shown;
    std::vector<LabelRequest> wanted;
    for (const Label& label : labels) {
        const auto at = projection.at(label.position);
        if (!at) continue;
        const bool seen = label.extent == 0.0F ||
                          projection.pixels(label.position, label.extent) >= kSeenFrom * em;
        if (!seen) continue;
        const Print print = printOf(context, label);
        const ImVec2 extent = print.font->CalcTextSizeA(print.size, 1e9F, 0.0F, label.text.c_str());
        shown.push_back(&label);
        wanted.push_back({*at, {extent.x + 0.44F * em, extent.y + 0.04F * em}, rankOf(label)});
    }
    const Rect& view = context.rects.view;
    const std::vector<LabelMark> marks = projection.marks();
    const OccupancyGrid occupancy = projection.occupancy();
    LabelRoom room{view, taken, marks, &occupancy, view.min + 0.5F * view.size, em};
    const DecisionState& picture = context.session().picture();
    if (context.session().ready() && picture.pivot != kNone) {
        room.middle =
            projection.at(context.session().shown().place[picture.pivot]).value_or(room.middle);
    }
    const std::vector<PlacedLabel> placed = placeLabels(room, wanted);
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (const PlacedLabel& each : placed) {
        if (!each.leader) continue;
        const glm::vec2 from = wanted[each.index].at;
        list->AddLine(toVec2(from), toVec2(nearestIn(each.plate, from)),
                      toU32(shown[each.index]->color.withAlpha(0.7F)), std::max(1.0F, 0.06F * em));
    }
    for (const PlacedLabel& each : placed) drawPlate(context, *shown[each.index], each.plate);
}

}  // namespace se::view
