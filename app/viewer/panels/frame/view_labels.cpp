/// The labels of the view.
#include <algorithm>

#include "document/ui_state.h"
#include "paint/view_texts.h"
#include "panels/widgets/screen_painter.h"
#include "scene/draw_list.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// Distance between a text and the edge of its plate, in em.
constexpr glm::vec2 kLabelMargin{0.22F, 0.02F};

/// In Present capitals are at least 4 % of the view high; they are 0.6 of a line.
Type typeOf(const PanelContext& context, const Label& label) {
    if (context.rects.layoutPreset == LayoutPreset::Present) {
        const float least = 0.04F / 0.6F * context.rects.view.size.y;
        return {std::max(least, context.em), Typeface::Caption};
    }
    if (label.strong) return {context.em, Typeface::Strong};
    return {0.88F * context.em};
}

/// `hovered`: the place of the point under the pointer, whose labels are all shown.
LabelRank rankOf(const Label& label, const glm::vec3* hovered) {
    return label.asked || (hovered != nullptr && label.position == *hovered) ? LabelRank::Asked
           : label.essential                                                 ? LabelRank::Essential
           : label.strong                                                    ? LabelRank::Strong
                                                                             : LabelRank::Minor;
}

}  // namespace

void drawLabels(const PanelContext& context, std::span<const Rect> taken) {
    const std::vector<Label>& labels = context.drawList.labels;
    std::vector<DrawnLabel>& drawn = context.ui().labels[context.beside ? 1 : 0];
    drawn.clear();
    if (labels.empty()) return;
    ScreenPainter painter(context);
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
        const glm::vec2 extent = painter.textSize(label.text, typeOf(context, label));
        shown.push_back(i);
        wanted.push_back({*at, extent + 2.0F * kLabelMargin * em, rankOf(label, hovered)});
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
        Type type = typeOf(context, labels[shown[each.index]]);
        type.length = each.plate.size.x - 2.0F * kLabelMargin.x * em;
        drawn.push_back({shown[each.index], wanted[each.index].at, each.plate,
                         each.plate.min + kLabelMargin * em, type, each.leader});
    }
    drawLabels(painter, drawn, context.drawList);
}

}  // namespace se::view
