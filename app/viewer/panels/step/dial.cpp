// The Dial panel: the sector of the pivot as a disc, and a second disc at decisions that have one.
#include <algorithm>

#include "paint/dial_painter.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/screen_painter.h"
#include "session/session.h"

namespace se::view {

namespace {

/// Size of the second disc, in em.
constexpr float kSecond = 6.2F;
constexpr float kBetween = 0.5F;
/// Minimum size of the first disc: with less beside it, the second one is below.
constexpr float kFirstWide = 10.4F;
/// Minimum height in a low panel, which scrolls.
constexpr float kLeastHigh = 9.0F;
/// Share of the height of the column.
constexpr float kColumnShare = 0.4F;

struct DialRooms {
    Rect main;
    std::optional<Rect> second;
    float height = 0.0F;  ///< Of both.
};

/// True if one of the decisions of this pivot has a second disc.
bool hasSecondDisc(const PanelContext& context) {
    const std::vector<Event>& events = context.session().record().events;
    return std::any_of(events.begin(), events.end(), [](const Event& each) {
        return std::holds_alternative<ReciprocalEvidence>(each.evidence);
    });
}

/// A pivot with a second disc at one of its decisions reserves room for it beside the first one at
/// all of them, so that the first one does not move. In a narrow panel the second one is below, and
/// has room only where it is drawn: the first one would be too small at all others.
DialRooms roomsIn(const Rect& room, const PanelContext& context, bool second) {
    const float em = context.em;
    const float least = std::min(kLeastHigh * em, room.size.x);
    const auto high = [&](float rest) { return std::max(std::min(rest, room.size.x), least); };
    DialRooms rooms{{room.min, {room.size.x, high(room.size.y)}}, std::nullopt, high(room.size.y)};
    if (!hasSecondDisc(context)) return rooms;
    const glm::vec2 below(kSecond * em);
    const glm::vec2 beside(kSecond * em, std::min(kSecond * em, rooms.height));
    const float rest = room.size.x - beside.x - kBetween * em;
    if (rest >= kFirstWide * em) {
        rooms.main.size.x = rest;
        rooms.second = Rect{room.min + glm::vec2(room.size.x, rooms.height) - beside, beside};
        return rooms;
    }
    if (!second) return rooms;
    rooms.main.size.y = high(room.size.y - below.y);
    rooms.height = rooms.main.size.y + below.y;
    rooms.second = Rect{room.min + glm::vec2(room.size.x, rooms.height) - below, below};
    return rooms;
}

void explain(const PanelContext& context, const DialTick& tick) {
    ImGui::BeginTooltip();
    ImGui::Text("point %s: %.1f\xC2\xB0", nameOf(tick.point, context.session().names()).c_str(),
                tick.degrees);
    const PointSet& points = context.session().shown().points;
    const Index p = context.session().picture().pivot;
    const double height =
        glm::dot(points.position[tick.point] - points.position[p], points.normal[p]);
    ImGui::TextDisabled("height %+.4g", height);
    if (!tick.note.empty()) ImGui::TextDisabled("%s", tick.note.c_str());
    ImGui::EndTooltip();
}

/// All of the area beside a picture; in the column the width, and a share of the height, so that
/// the numbers below the dial are seen as well.
ImVec2 roomOf(const PanelContext& context) {
    ImVec2 room = ImGui::GetContentRegionAvail();
    if (context.rects.dial.size.x <= 0.0F)
        room.y = std::min(room.x + 2.0F * context.em, kColumnShare * context.rects.column.size.y);
    return room;
}

}  // namespace

void drawDial(const PanelContext& context) {
    Session& session = context.session();
    const DecisionState& state = session.picture();
    const Dial dial = makeDial(session.shown().points, session.shown().params, state);
    if (dial.empty()) {
        return dimText(noPivotText(session));
    }
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = roomOf(context);
    const std::vector<std::string> caption = wrapped(dial.caption, room.x);
    const float captionHeight = ImGui::GetTextLineHeightWithSpacing() *
                                static_cast<float>(std::max<std::size_t>(1, caption.size()));
    const DialRooms rooms = roomsIn({{corner.x, corner.y}, {room.x, room.y - captionHeight}},
                                    context, dial.reciprocal.has_value());
    const float height = rooms.height;
    const Rect whole{{corner.x, corner.y}, {room.x, height}};
    ScreenPainter painter(context);
    const DialPicture picture{dial, session.names(), session.highlights().hovered(),
                              session.selected()};
    const DialCircle disc = discOf(painter, picture, rooms.main);
    if (disc.radius < 2.0F * context.em) return;
    ImGui::InvisibleButton("##dial", {room.x, height});
    const bool second = dial.reciprocal && rooms.second;
    drawDialDisc(painter, picture, disc, whole,
                 second ? std::span<const Rect>(&*rooms.second, 1) : std::span<const Rect>{});
    if (second) drawReciprocalDial(painter, picture, *rooms.second);
    if (ImGui::IsItemHovered()) {
        const DialTick* tick = nearestToPointer(
            dial.ticks, context.em, [&](const DialTick& each) { return placeOf(each, disc); });
        if (tick != nullptr) {
            context.state<Navigation>().pointedAt = tick->point;
            explain(context, *tick);
            if (ImGui::IsItemClicked()) session.select(tick->point);
        }
    }
    for (const std::string& line : caption) {
        const float margin = 0.5F * (room.x - textWidth(line));
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, margin));
        ImGui::TextUnformatted(line.c_str());
    }
}

}  // namespace se::view
