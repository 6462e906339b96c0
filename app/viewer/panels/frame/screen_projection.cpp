// Places that the overlays must not cover, in pixels: the marks, the points of the decisions, and a
// grid with the amount of drawing. All of it is projected again in each frame, hence the limits on
// its parts.

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "document/ui_state.h"
#include "paint/labels.h"
#include "panels/widgets/screen_painter.h"
#include "run/model.h"
#include "scene/camera.h"
#include "scene/draw_list.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// Maximum number of items: a position has to be found within a frame.
constexpr std::size_t kMaxLines = 4000;
constexpr std::size_t kMaxSprites = 400;
constexpr std::size_t kMaxFaces = 400;
constexpr std::size_t kMaxSights = 48;
/// Marks of this size, in em, belong to points that must stay visible.
constexpr float kMarkFrom = 0.9F;
/// Size of a cell of the occupancy grid, in em, and the weights of faces and of marks in it.
constexpr float kCell = 0.5F;
constexpr float kFaceWeight = 0.5F;
constexpr float kSpotWeight = 1.0F;
/// Marks of candidates, from this size on, count more.
constexpr float kCandidateFrom = 0.6F;
constexpr float kCandidateWeight = 4.0F;
/// Free radius around the pivot and around the others, in em.
constexpr float kAboutPivot = 1.6F;
constexpr float kAboutOthers = 0.7F;

}  // namespace

ScreenProjection::ScreenProjection(const PanelContext& context)
    : context_(context), view_(context.rects.view), camera_(cameraOf(context)) {}

std::optional<glm::vec2> ScreenProjection::at(const glm::vec3& place) const {
    const glm::vec3 seen = project(camera_, place, view_.size);
    if (seen.z <= 0.0F) return std::nullopt;
    return view_.min + glm::vec2(seen);
}

float ScreenProjection::pixels(const glm::vec3& place, float length) const {
    const glm::vec3 right(camera_.view[0][0], camera_.view[1][0], camera_.view[2][0]);
    const auto from = at(place);
    const auto to = at(place + length * right);
    return from && to ? glm::distance(*from, *to) : 0.0F;
}

std::vector<LabelMark> ScreenProjection::marks() const {
    std::vector<LabelMark> all;
    for (const Sprite& sprite : context_.drawList.sprites) {
        if (sprite.style.size < kMarkFrom || all.size() == kMaxSights) continue;
        const auto place = at(sprite.position);
        if (!place || !view_.contains(*place)) continue;
        all.push_back({*place, 0.5F * kMaxMarkZoom * sprite.style.size * context_.em});
    }
    return all;
}

std::vector<LabelMark> ScreenProjection::neighborhood() const {
    std::vector<LabelMark> all;
    if (!context_.session().ready()) return all;
    const Session& session = context_.session();
    for (const Index point : neighborhoodOf(session.picture())) {
        const auto place = at(session.shown().place[point]);
        if (!place) continue;
        const bool pivot = point == session.picture().pivot;
        all.push_back({*place, (pivot ? kAboutPivot : kAboutOthers) * context_.em});
    }
    return all;
}

OccupancyGrid ScreenProjection::occupancy() const {
    const DrawList& drawn = context_.drawList;
    OccupancyGrid all(view_, kCell * context_.em);
    for (std::size_t i = 0; i < std::min(kMaxLines, drawn.lines.size()); ++i) {
        const Line& line = drawn.lines[i];
        const auto from = at(line.from);
        const auto to = at(line.to);
        if (from && to) all.addLine(*from, *to, line.color.a);
    }
    for (std::size_t i = 0; i < std::min(kMaxSprites, drawn.sprites.size()); ++i) {
        const PointStyle& style = drawn.sprites[i].style;
        const auto place = at(drawn.sprites[i].position);
        const float weight = style.size >= kCandidateFrom ? kCandidateWeight : kSpotWeight;
        if (place) all.addSpot(*place, 0.5F * style.size * context_.em, weight);
    }
    for (std::size_t i = 0; i < std::min(kMaxFaces, drawn.faces.size()); ++i) {
        const std::array<glm::vec3, 3>& corners = drawn.faces[i].corners;
        const auto a = at(corners[0]);
        const auto b = at(corners[1]);
        const auto c = at(corners[2]);
        if (a && b && c) all.addTriangle(*a, *b, *c, kFaceWeight);
    }
    all.finish();
    return all;
}

// The labels of the view.

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
    if (label.asked || (hovered != nullptr && label.position == *hovered)) return LabelRank::Asked;
    return label.essential ? LabelRank::Essential
           : label.given   ? LabelRank::Given
           : label.strong  ? LabelRank::Strong
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
