// The Rings panel: active and stacked rings, and one of them unrolled as a line.
#include <algorithm>
#include <cmath>
#include <utility>

#include "document/ui_state.h"
#include "input/key_routing.h"
#include "paint/shapes.h"
#include "panels/widgets/screen_painter.h"
#include "rows/lane_picture.h"
#include "scene/framing.h"
#include "session/session.h"

namespace se::view {

namespace {

/// Height of the strip under the list, in em.
constexpr float kStripHeight = 4.4F;
/// Distance between points of the strip, beyond the width of a number.
constexpr float kPointGap = 0.9F;

/// Frames a ring; the direction stays.
void frameRing(const PanelContext& context, const RingPath& ring) {
    const Model& model = context.session().model();
    std::vector<glm::vec3> places;
    places.reserve(ring.points.size());
    for (const Index point : ring.points) places.push_back(model.place[point]);
    framePlaces(places, 2.0F * model.spacing, context.ui().viewPart(), kDecisionShare,
                context.camera());
}

void drawRow(const PanelContext& context, const RingPath& ring) {
    Session& session = context.session();
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(ring.number));
    const bool kept = ring.id != kNone && session.highlights().chosenRing() == ring.id;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    constexpr auto kWholeRow =
        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
    if (ImGui::Selectable("##ring", kept, kWholeRow)) {
        ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)
            ? frameRing(context, ring)
            : session.highlights().chooseRing(ring.id);
    }
    if (ImGui::IsItemHovered()) {
        context.state<Navigation>().pointedRing = ring.id;
        tooltip("Click: highlight it. Double click: show all of it. Right click: why is it there?");
        if (ImGui::IsMouseReleased(ImGuiMouseButton_Right) && session.event() != nullptr) {
            context.state<SubjectMenu>().open(
                RingAddress{session.address(), ring.active ? 0 : ring.depth + 1});
        }
    }
    const bool first = &ring == &session.picture().rings.front();
    if (first && context.state<KeyWalk>().offer(KeyStop::Rings)) takeKeyboard();
    const bool lit = ring.id != kNone && session.highlights().litRing() == ring.id;
    ScreenPainter painter(context);
    const auto drawSign = ring.active ? drawActiveRing : drawWaitingRing;
    drawSign(painter, {at.x, at.y + 0.5F * ImGui::GetTextLineHeight()}, context.em,
             painter.ink(lit ? &Palette::pivot : &Palette::used));
    ImGui::TableNextColumn();
    ImGui::TextUnformatted((ringName(ring.number) + (ring.active ? ", active" : "")).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted((grouped(ring.points.size()) + " points").c_str());
    const auto open = std::count(ring.open.begin(), ring.open.end(), true);
    if (open > 0) {
        ImGui::SameLine();
        ImGui::TextDisabled("%ld open", static_cast<long>(open));
    }
    ImGui::PopID();
}

// ---- the strip ------------------------------------------------------------------------------

/// The part of the ring that is shown: about the current work, or shifted by the wheel.
struct SliceShift {
    long points = 0;
    CursorWatch watch;  ///< A move of the cursor ends the shift.
};

/// One ring along a line, from left to right in its direction.
struct RingStrip {
    const PanelContext& context;
    const RingPath& ring;
    RingSlice slice;
    ImVec2 at;  ///< Left end of the line.
    float pitch = 1.0F;
    ScreenPainter p{context};

    float xOf(std::size_t i) const { return at.x + (static_cast<float>(i) + 0.5F) * pitch; }
};

void drawStep(RingStrip& strip, std::size_t i) {
    const float em = strip.context.em;
    const float y = strip.at.y;
    const Ink ink = strip.p.ink(&Palette::used);
    const float from = strip.xOf(i) + 0.4F * em;
    const float to = strip.xOf(i) + strip.pitch - 0.4F * em;
    if (to <= from) return;
    if (strip.ring.open[strip.slice.at(i)]) {
        // No edge of the mesh: dotted, as in the view.
        for (float x = from; x < to; x += 0.3F * em)
            strip.p.circle({x + 0.06F * em, y}, 0.07F * em, ink);
        return;
    }
    strip.p.line({from, y}, {to, y}, ink.line(std::max(1.5F, 0.14F * em)));
    drawShape(strip.p, {0.5F * (from + to), y}, 0.46F * em, Shape::Forward, ink);
}

struct PointLook {
    Shape shape = Shape::Disc;
    float size = 0.5F;
    Color Palette::*color;
};

PointLook lookOf(const DecisionState& picture, Index point) {
    if (point == picture.pivot) return {Shape::RingedDisc, 1.0F, &Palette::pivot};
    if (point == picture.nextPivot) return {Shape::RingedDisc, 0.85F, &Palette::text};
    if (point == picture.start) return {Shape::Forward, 0.75F, &Palette::first};
    if (point == picture.end) return {Shape::Back, 0.75F, &Palette::last};
    if (point == picture.first) return {Shape::Forward, 0.55F, &Palette::first};
    if (point == picture.last) return {Shape::Back, 0.55F, &Palette::last};
    return {Shape::Disc, 0.45F, &Palette::used};
}

/// Role of a point for the pivot, for the line above the strip.
std::string roleOf(const DecisionState& picture, Index point) {
    const std::pair<Index, const char*> roles[] = {
        {picture.pivot, "pivot"}, {picture.first, "first"}, {picture.last, "last"},
        {picture.start, "start"}, {picture.end, "end"},     {picture.nextPivot, "next pivot"}};
    std::string text;
    for (const auto& [which, name] : roles) {
        if (which != kNone && which == point)
            text += (text.empty() ? "" : ", ") + std::string(name);
    }
    return text;
}

void drawPoint(RingStrip& strip, std::size_t i) {
    const PanelContext& context = strip.context;
    Session& session = context.session();
    const float em = context.em;
    const Index point = strip.ring.points[strip.slice.at(i)];
    const PointLook look = lookOf(session.picture(), point);
    const float x = strip.xOf(i);
    ScreenPainter& p = strip.p;
    drawShape(p, {x, strip.at.y}, look.size * em, look.shape, p.ink(look.color));
    if (point == session.selected() || point == session.highlights().hovered())
        p.circle({x, strip.at.y}, 0.62F * em, p.ink(&Palette::text).line(p.px(0.1F)));
    const std::string number = nameOf(point, session.names());
    p.text({x, strip.at.y + 0.65F * em}, number,
           p.ink(look.shape == Shape::Disc ? &Palette::textDim : &Palette::text),
           {0.8F * em, Typeface::Text, Align::Middle});
    ImGui::SetCursorScreenPos({x - 0.5F * strip.pitch, strip.at.y - 0.7F * em});
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("##point", {strip.pitch, 2.3F * em})) session.select(point);
    const bool middle = i == strip.slice.count / 2;
    if (middle && context.state<KeyWalk>().offer(KeyStop::RingPoints)) takeKeyboard();
    if (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible)
        context.state<Navigation>().pointedAt = point;
    if (ImGui::IsItemHovered()) {
        context.state<Navigation>().pointedAt = point;
        if (ImGui::IsMouseReleased(ImGuiMouseButton_Right))
            context.state<SubjectMenu>().open(Selection::ofPoint(point));
        const std::string role = roleOf(session.picture(), point);
        tooltip("point " + number + (role.empty() ? "" : ": " + role) +
                "\nClick selects it; the wheel moves along the ring.");
    }
    ImGui::PopID();
}

/// The whole ring as a thin bar: the part in the strip, and the position of current work.
void drawWhole(RingStrip& strip, float width, std::optional<std::size_t> work) {
    const float em = strip.context.em;
    const glm::vec2 low(strip.at.x, strip.at.y + 1.85F * em);
    const glm::vec2 high(low.x + width, low.y + 0.35F * em);
    strip.p.box(low, high, strip.p.ink(&Palette::panelRaised), 0.1F * em);
    const auto xOf = [&](std::size_t place) {
        return low.x + width * static_cast<float>(place) / static_cast<float>(strip.slice.size);
    };
    const auto part = [&](std::size_t from, std::size_t to) {
        strip.p.box({xOf(from), low.y}, {std::max(xOf(to), xOf(from) + 2.0F), high.y},
                    strip.p.ink(&Palette::used), 0.1F * em);
    };
    const std::size_t end = strip.slice.first + strip.slice.count;
    part(strip.slice.first, std::min(end, strip.slice.size));
    if (end > strip.slice.size) part(0, end - strip.slice.size);
    if (work) {
        const float x = xOf(*work);
        strip.p.box({x - 1.0F, low.y - 0.15F * em}, {x + 1.0F, high.y + 0.15F * em},
                    strip.p.ink(&Palette::pivot));
    }
}

void drawStrip(const PanelContext& context, const RingPath& ring) {
    const Session& session = context.session();
    SliceShift& shift = context.state<SliceShift>();
    const float em = context.em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float widest = textWidth(std::to_string(session.model().points.size()));
    const float least = 0.8F * widest + kPointGap * em;
    const auto work = workPlace(session.picture(), ring);
    if (shift.watch.moved(session.generation(), session.record().pivot, session.cursor()))
        shift.points = 0;
    const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) &&
                         ImGui::IsMouseHoveringRect(at, {at.x + width, at.y + kStripHeight * em});
    if (hovered) shift.points -= static_cast<long>(ImGui::GetIO().MouseWheel);
    const auto fits = static_cast<std::size_t>(std::max(1.0F, width / least));
    RingStrip strip{context, ring, {}, {at.x, at.y + 1.9F * em}, least};
    strip.slice = sliceAbout(ring.points.size(), work.value_or(0), shift.points, fits);
    strip.pitch = width / static_cast<float>(std::max<std::size_t>(1, strip.slice.count));
    strip.pitch = std::min(strip.pitch, 1.6F * least);
    const std::string title = "ring " + ringName(ring.number) + ", in its direction";
    dimShortText(title, width);
    for (std::size_t i = 0; i < strip.slice.count; ++i) {
        if (i + 1 < strip.slice.count) drawStep(strip, i);
        drawPoint(strip, i);
    }
    if (!strip.slice.whole()) drawWhole(strip, width, work);
    context.where()["strip ring"] = {{at.x, at.y}, {width, kStripHeight * em}};
}

/// Rows are whole at the upper end of the list at any scroll position.
void snapToRows(float row) {
    const float at = ImGui::GetScrollY();
    const float whole = std::round(at / row) * row;
    if (at < ImGui::GetScrollMaxY() && whole != at) ImGui::SetScrollY(whole);
}

void drawList(const PanelContext& context, float height, float row) {
    const auto& rings = context.session().picture().rings;
    if (!ImGui::BeginTable("##rings", 3, ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit,
                           {0.0F, height})) {
        return;
    }
    ImGui::TableSetupColumn("mark", ImGuiTableColumnFlags_WidthFixed, 2.0F * context.em);
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 4.2F * context.em);
    ImGui::TableSetupColumn("length", ImGuiTableColumnFlags_WidthStretch);
    drawSeen(rings.size(), -1.0F, [&](std::size_t i) { drawRow(context, rings[i]); });
    snapToRows(row);
    ImGui::EndTable();
}

}  // namespace

void drawRings(const PanelContext& context) {
    const Session& session = context.session();
    const std::size_t count = session.picture().rings.size();
    const std::size_t stacked = stackedCount(session.picture().rings);
    partNote(stacked > 0 ? std::to_string(stacked) + " stacked" : std::string{});
    if (count == 0) {
        dimText(session.atEnd() ? "No ring: the run is finished."
                                : "No ring: the next seed begins one. F10 goes there.");
        return;
    }
    const float em = context.em;
    const float row = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    const float room = ImGui::GetContentRegionAvail().y;
    // Whole rows: half a row would look like the end of the list.
    const float rows = std::floor((room - kStripHeight * em - 0.4F * em) / row);
    drawList(context, std::clamp(rows, 1.0F, static_cast<float>(count)) * row, row);
    const RingPath* shown = ringToShow(session.picture(), session.highlights().chosenRing());
    if (shown != nullptr && !shown->points.empty()) drawStrip(context, *shown);
}

}  // namespace se::view
