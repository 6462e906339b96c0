/// The labels of the view.
#include <algorithm>

#include "document/ui_state.h"
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

/// In Present capitals are at least 4 % of the view high; they are 0.6 of a line.
Print printOf(const PanelContext& context, const Label& label) {
    if (context.rects.layoutPreset == LayoutPreset::Present) {
        const float least = 0.04F / 0.6F * context.rects.view.size.y;
        return {context.fonts.caption, std::max(least, context.em)};
    }
    if (label.strong) return {context.fonts.strong, context.em};
    return {context.fonts.text, 0.88F * context.em};
}

/// `hovered`: the place of the point under the pointer, whose labels are all shown.
LabelRank rankOf(const Label& label, const glm::vec3* hovered) {
    return label.asked || (hovered != nullptr && label.position == *hovered) ? LabelRank::Asked
           : label.essential                                                 ? LabelRank::Essential
           : label.strong                                                    ? LabelRank::Strong
                                                                             : LabelRank::Minor;
}

void drawPlate(const PanelContext& context, const DrawnLabel& drawn) {
    const Label& label = context.drawList.labels[drawn.index];
    ImDrawList* list = ImGui::GetWindowDrawList();
    fill(list, drawn.plate, context.palette.background.withAlpha(kPlateAlpha), 0.2F * context.em);
    list->AddText(printOf(context, label).font, drawn.size, toVec2(drawn.text), toU32(label.color),
                  label.text.c_str());
}

}  // namespace

void drawLabels(const PanelContext& context, std::span<const Rect> taken) {
    const std::vector<Label>& labels = context.drawList.labels;
    std::vector<DrawnLabel>& drawn = context.ui().labels[context.beside ? 1 : 0];
    drawn.clear();
    if (labels.empty()) return;
    const ScreenProjection projection(context);
    const float em = context.em;
    const Session& session = context.session();
    const Index under = session.highlights().hovered();
    const glm::vec3* hovered =
        session.ready() && under != kNone ? &session.shown().place[under] : nullptr;
    std::vector<std::size_t> shown;
    std::vector<LabelRequest> wanted;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Label& label = labels[i];
        const auto at = projection.at(label.position);
        if (!at) continue;
        const bool seen = label.extent == 0.0F ||
                          projection.pixels(label.position, label.extent) >= kSeenFrom * em;
        if (!seen) continue;
        const Print print = printOf(context, label);
        const ImVec2 extent = print.font->CalcTextSizeA(print.size, 1e9F, 0.0F, label.text.c_str());
        shown.push_back(i);
        wanted.push_back(
            {*at, {extent.x + 0.44F * em, extent.y + 0.04F * em}, rankOf(label, hovered)});
    }
    const Rect& view = context.rects.view;
    const std::vector<LabelMark> marks = projection.marks();
    const OccupancyGrid occupancy = projection.occupancy();
    LabelRoom room{view, taken, marks, &occupancy, view.min + 0.5F * view.size, em};
    const DecisionState& picture = session.picture();
    if (session.ready() && picture.pivot != kNone) {
        room.middle = projection.at(session.shown().place[picture.pivot]).value_or(room.middle);
    }
    for (const PlacedLabel& each : placeLabels(room, wanted)) {
        drawn.push_back({shown[each.index], wanted[each.index].at, each.plate,
                         each.plate.min + glm::vec2(0.22F, 0.02F) * em,
                         printOf(context, labels[shown[each.index]]).size, each.leader});
    }
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (const DrawnLabel& each : drawn) {
        if (!each.leader) continue;
        list->AddLine(toVec2(each.at), toVec2(nearestIn(each.plate, each.at)),
                      toU32(labels[each.index].color.withAlpha(kLeaderAlpha)),
                      std::max(1.0F, kLeaderEms * em));
    }
    for (const DrawnLabel& each : drawn) drawPlate(context, each);
}

}  // namespace se::view
