#include "run/dial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "interface/dial_fit.h"
#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

constexpr float kDegree = 3.14159265F / 180.0F;
/// Between the rim and a name, in em.
constexpr float kNameGap = 0.35F;

/// The disc on the screen: angle 0 to the right, counterclockwise.
struct Disc {
    ImVec2 center;
    float radius = 0.0F;

    ImVec2 at(double degrees, float reach) const {
        const float a = static_cast<float>(degrees) * kDegree;
        return {center.x + reach * radius * std::cos(a), center.y - reach * radius * std::sin(a)};
    }
};

/// A sector, in parts of at most half a turn: only those are convex.
void fillSector(const Disc& disc, double from, double to, float reach, const Color& color) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (double a = from; a < to - 1e-6; a += 180.0) {
        const double b = std::min(a + 180.0, to);
        list->PathLineTo(disc.center);
        list->PathArcTo(disc.center, reach * disc.radius, -static_cast<float>(a) * kDegree,
                        -static_cast<float>(b) * kDegree, 48);
        list->PathFillConvex(toU32(color));
    }
}

class DialDrawer {
  public:
    DialDrawer(const PanelContext& context, const Dial& dial, const Disc& disc)
        : c_(context), dial_(dial), disc_(disc), list_(ImGui::GetWindowDrawList()) {}

    /// `room` is where names may stand.
    void draw(const Rect& room) {
        room_ = room;
        const Palette& colors = c_.palette;
        list_->AddCircleFilled(disc_.center, disc_.radius, toU32(colors.background), 96);
        for (const DialArc& arc : dial_.arcs) drawArc(arc);
        for (const DialSlot& slot : dial_.slots) drawSlot(slot);
        if (dial_.chord) drawChord(*dial_.chord);
        list_->AddCircle(disc_.center, disc_.radius, toU32(colors.border), 96, px());
        for (const DialTick& tick : dial_.ticks) drawTick(tick);
        drawShape(list_, disc_.center, 1.15F * c_.em, Shape::RingedDisc, toU32(colors.pivot));
        // Where names would cover one another, the first stays: the one that matters most.
        for (const DialTick& tick : dial_.ticks) {
            if (tick.underTest) drawName(tick);
        }
        for (const DialTick& tick : dial_.ticks) {
            if (!tick.underTest) drawName(tick);
        }
        for (const DialMark& mark : dial_.marks) drawMark(mark.degrees, mark.text.c_str());
    }

    /// The tick nearest to the pointer, null if none is near.
    const DialTick* underPointer() const {
        const ImVec2 mouse = ImGui::GetMousePos();
        const DialTick* best = nullptr;
        float bestDistance = c_.em;
        for (const DialTick& tick : dial_.ticks) {
            const ImVec2 at = tip(tick);
            const float distance = std::hypot(mouse.x - at.x, mouse.y - at.y);
            if (distance >= bestDistance) continue;
            bestDistance = distance;
            best = &tick;
        }
        return best;
    }

  private:
    float px(float width = 0.08F) const { return std::max(1.0F, width * c_.em); }
    ImVec2 tip(const DialTick& tick) const {
        return disc_.at(tick.degrees, 0.92F * std::max(0.12F, tick.reach));
    }

    void strokeArc(double from, double to, float reach, const Color& color, float width,
                   bool dashed) {
        const int parts = std::max(2, static_cast<int>((to - from) / 4.0));
        for (int i = 0; i < parts; ++i) {
            if (dashed && i % 2 == 1) continue;
            list_->AddLine(disc_.at(from + (to - from) * i / parts, reach),
                           disc_.at(from + (to - from) * (i + 1) / parts, reach), toU32(color),
                           px(width));
        }
    }

    void drawArc(const DialArc& arc) {
        const Palette& colors = c_.palette;
        switch (arc.kind) {
            case DialArc::Kind::Range:
                fillSector(disc_, arc.from, arc.to, 1.0F, colors.pivot.withAlpha(0.15F));
                strokeArc(arc.from, arc.to, 1.0F, colors.pivot.withAlpha(0.9F), 0.16F, false);
                break;
            case DialArc::Kind::OldRange:
                strokeArc(arc.from, arc.to, 1.05F, colors.textDim, 0.1F, true);
                break;
            case DialArc::Kind::Gap:
                strokeArc(arc.from, arc.to, 0.5F, colors.test, 0.22F, false);
                break;
            case DialArc::Kind::TooWide:
                strokeArc(arc.from, arc.to, 0.5F, colors.rejected, 0.22F, true);
                break;
            case DialArc::Kind::Angle:
                strokeArc(arc.from, arc.to, 0.4F, colors.test, 0.16F, false);
                break;
            case DialArc::Kind::Triangle:
                fillSector(disc_, arc.from, arc.to, 0.9F, colors.test.withAlpha(0.3F));
                break;
        }
    }

    /// The plane of §6.2 seen from above: what lies beyond the chord is hatched.
    void drawChord(const DialChord& chord) {
        const ImU32 color = toU32(c_.palette.rejected.withAlpha(0.6F));
        constexpr int kLines = 12;
        for (int i = 1; i < kLines; ++i) {
            const double degrees = chord.from + (chord.to - chord.from) * i / kLines;
            const double middle = 0.5 * (chord.from + chord.to);
            const double half = 0.5 * (chord.to - chord.from);
            const auto reach = static_cast<float>(std::cos(half * kDegree) /
                                                  std::cos((degrees - middle) * kDegree));
            list_->AddLine(disc_.at(degrees, reach), disc_.at(degrees, 1.0F), color, px(0.06F));
        }
        list_->AddLine(disc_.at(chord.from, 1.0F), disc_.at(chord.to, 1.0F),
                       toU32(c_.palette.rejected), px(0.14F));
    }

    void drawMark(double degrees, const char* text) {
        const ImU32 color = toU32(c_.palette.textDim);
        list_->AddLine(disc_.at(degrees, 0.86F), disc_.at(degrees, 1.05F), color, px(0.14F));
        place(disc_.at(degrees, 1.0F), degrees, text, c_.palette.textDim, 0.75F);
    }

    /// A place on the ring beside the pivot, filled if the third point went there.
    void drawSlot(const DialSlot& slot) {
        const ImU32 color = toU32(c_.palette.test);
        const float half = 0.45F * c_.em;
        const ImVec2 at = disc_.at(slot.degrees, 0.78F);
        const ImVec2 low(at.x - half, at.y - half);
        const ImVec2 high(at.x + half, at.y + half);
        slot.filled ? list_->AddRectFilled(low, high, color)
                    : list_->AddRect(low, high, color, 0.0F, 0, px(0.1F));
        place(disc_.at(slot.degrees, 1.0F), slot.degrees, slot.text, c_.palette.test, 0.8F);
    }

    /// What was refused is hatched at the rim: the reason is in the tooltip and the caption.
    void drawRefusal(const DialTick& tick, const ImU32 color) {
        for (int i = -2; i <= 2; ++i) {
            const double degrees = tick.degrees + 2.2 * i;
            list_->AddLine(disc_.at(degrees - 2.0, 0.93F), disc_.at(degrees + 2.0, 1.0F), color,
                           px(0.06F));
        }
    }

    Color colorOf(const DialTick& tick) const {
        const Palette& colors = c_.palette;
        switch (tick.role) {
            case DialRole::Neighbor:
                return colors.unused;
            case DialRole::Done:
                return colors.done;
            case DialRole::Candidate:
                return tick.underTest ? colors.test : colors.used;
            case DialRole::Rejected:
                return colors.rejected;
            case DialRole::First:
            case DialRole::Start:
                return colors.first;
            case DialRole::Last:
            case DialRole::End:
                return colors.last;
        }
        return colors.text;
    }

    static Shape shapeOf(DialRole role) {
        switch (role) {
            case DialRole::Neighbor:
                return Shape::Circle;
            case DialRole::Done:
                return Shape::Dot;
            case DialRole::Candidate:
                return Shape::Disc;
            case DialRole::Rejected:
                return Shape::Cross;
            case DialRole::First:
            case DialRole::Start:
                return Shape::Forward;
            case DialRole::Last:
            case DialRole::End:
                return Shape::Back;
        }
        return Shape::Disc;
    }

    void drawTick(const DialTick& tick) {
        const Color color = colorOf(tick);
        const ImVec2 at = tip(tick);
        const bool faint = tick.role == DialRole::Neighbor || tick.role == DialRole::Done;
        if (!faint) {
            const bool rejected = tick.role == DialRole::Rejected;
            list_->AddLine(disc_.center, at, toU32(color.withAlpha(rejected ? 0.45F : 0.9F)),
                           px(tick.underTest ? 0.14F : 0.08F));
        }
        // The height above the plane, as a stem: up is the outer side.
        const float stem = tick.height * disc_.radius;
        if (std::abs(stem) > 0.2F * c_.em) {
            const ImVec2 top(at.x, at.y - stem);
            list_->AddLine(at, top, toU32(color.withAlpha(0.8F)), px(0.07F));
            list_->AddLine({top.x - 0.2F * c_.em, top.y}, {top.x + 0.2F * c_.em, top.y},
                           toU32(color.withAlpha(0.8F)), px(0.07F));
        }
        const float size = (tick.role == DialRole::Done ? 0.4F : faint ? 0.5F : 0.72F) * c_.em;
        drawShape(list_, at, size, shapeOf(tick.role), toU32(color));
        if (tick.role == DialRole::Rejected) drawRefusal(tick, toU32(color));
        if (tick.passed) {
            list_->AddLine(disc_.at(tick.degrees, 0.94F), disc_.at(tick.degrees, 1.0F),
                           toU32(color), px(0.3F));
        }
        if (tick.rank > 0) {
            const std::string rank = std::to_string(tick.rank) + ".";
            list_->AddText(c_.fonts.text, 0.75F * c_.em, rankPlace(tick), toU32(c_.palette.text),
                           rank.c_str());
        }
        const bool lit = tick.point == c_.session().hovered();
        if (tick.underTest) {
            list_->AddCircle(at, 0.62F * c_.em, toU32(c_.palette.test), 0, px(0.12F));
        }
        if (lit || tick.point == c_.session().selected()) {
            list_->AddCircle(at, 0.78F * c_.em, toU32(c_.palette.text), 0, px(0.1F));
        }
    }

    void drawName(const DialTick& tick) {
        const bool faint = tick.role == DialRole::Neighbor || tick.role == DialRole::Done;
        const bool lit = tick.underTest || tick.point == c_.session().hovered();
        if (faint && !lit) return;
        const std::string letter = tick.letter.empty() ? "" : tick.letter + " ";
        place(disc_.at(tick.degrees, 1.0F), tick.degrees, letter + std::to_string(tick.point),
              lit ? c_.palette.text : colorOf(tick), 0.8F);
    }

    /// Writes outside of the rim, unless something is written there already.
    void place(ImVec2 rim, double degrees, const std::string& text, const Color& color,
               float scale) {
        const float size = scale * c_.em;
        const ImVec2 extent = c_.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, text.c_str());
        const glm::vec2 plate(extent.x, extent.y);
        const glm::vec2 wished = nameCorner({rim.x, rim.y}, {degrees, plate}, kNameGap * c_.em);
        // Of two that coincide the second goes below or above the first.
        for (const float line : {0.0F, 1.0F, -1.0F}) {
            glm::vec2 low = wished + glm::vec2(0.0F, line * plate.y);
            low = glm::clamp(low, room_.min, glm::max(room_.min, room_.max() - plate));
            const Rect rect{low, plate};
            if (isTaken(rect)) continue;
            taken_.push_back(rect);
            list_->AddText(c_.fonts.text, size, toVec2(low), toU32(color), text.c_str());
            return;
        }
    }

    bool isTaken(const Rect& rect) const {
        return std::any_of(taken_.begin(), taken_.end(), [&](const Rect& other) {
            return rect.min.x < other.max().x && other.min.x < rect.max().x &&
                   rect.min.y < other.max().y && other.min.y < rect.max().y;
        });
    }

    /// Along the spoke, where it is clear of the marks of other points.
    ImVec2 rankPlace(const DialTick& tick) const {
        const float reach = std::max(0.12F, tick.reach);
        for (const float part : {0.5F, 0.65F, 0.38F, 0.78F}) {
            const ImVec2 at = disc_.at(tick.degrees, part * reach);
            const bool clear =
                std::none_of(dial_.ticks.begin(), dial_.ticks.end(), [&](const DialTick& other) {
                    const ImVec2 mark = tip(other);
                    return std::hypot(mark.x - at.x - 0.3F * c_.em, mark.y - at.y - 0.4F * c_.em) <
                           0.9F * c_.em;
                });
            if (clear) return at;
        }
        return disc_.at(tick.degrees, 0.5F * reach);
    }

    const PanelContext& c_;
    const Dial& dial_;
    Disc disc_;
    ImDrawList* list_;
    Rect room_;
    std::vector<Rect> taken_;
};

/// The second disc (Fig. 6): the pivot as e sees it.
void drawReciprocal(const PanelContext& context, const DialReciprocal& r, const Disc& disc) {
    const Palette& colors = context.palette;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float stroke = std::max(1.0F, 0.08F * context.em);
    list->AddCircleFilled(disc.center, disc.radius, toU32(colors.background), 48);
    fillSector(disc, 0.0, r.limitDegrees, 1.0F, colors.test.withAlpha(0.25F));
    list->AddCircle(disc.center, disc.radius, toU32(colors.border), 48, stroke);
    const Color color = r.inside ? colors.used : colors.rejected;
    const ImVec2 at = disc.at(r.pivotDegrees, 0.9F);
    list->AddLine(disc.center, at, toU32(color), 1.5F * stroke);
    drawShape(list, at, 0.6F * context.em, r.inside ? Shape::Disc : Shape::Cross, toU32(color));
    drawShape(list, disc.center, 0.6F * context.em, Shape::RingedDisc, toU32(colors.test));
    const std::string name = "e " + std::to_string(r.e);
    const float size = 0.8F * context.em;
    const ImVec2 extent = context.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, name.c_str());
    list->AddText(context.fonts.text, size,
                  {disc.center.x - 0.5F * extent.x, disc.center.y - disc.radius - 1.1F * extent.y},
                  toU32(colors.textDim), name.c_str());
}

/// Room is left for the names of all points that matter, tested or not: the disc stays where it is
/// while the decisions of a pivot go by.
Disc discIn(const Rect& room, const PanelContext& context, const Dial& dial) {
    const float size = 0.8F * context.em;
    std::vector<DialName> names;
    const auto add = [&](double degrees, const std::string& text) {
        const ImVec2 extent = context.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, text.c_str());
        names.push_back({degrees, {extent.x, extent.y}});
    };
    for (const DialTick& tick : dial.ticks) {
        if (tick.role == DialRole::Done) continue;
        add(tick.degrees,
            (tick.letter.empty() ? "" : tick.letter + " ") + std::to_string(tick.point));
    }
    for (const DialMark& mark : dial.marks) add(mark.degrees, mark.text);
    const DialPlace place = fitDial(room, names, kNameGap * context.em, 0.35F * context.em);
    return {toVec2(place.center), place.radius};
}

void explain(const PanelContext& context, const DialTick& tick) {
    char line[96];
    std::snprintf(line, sizeof line, "point %u: %.1f\xC2\xB0", tick.point, tick.degrees);
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(line);
    const PointSet& points = context.session().model().points;
    const Index p = context.session().picture().pivot;
    const double height =
        glm::dot(points.position[tick.point] - points.position[p], points.normal[p]);
    ImGui::TextDisabled("height %+.4g", height);
    if (!tick.note.empty()) ImGui::TextDisabled("%s", tick.note.c_str());
    ImGui::EndTooltip();
}

}  // namespace

void drawDial(const PanelContext& context) {
    Session& session = context.session();
    if (!session.ready()) return;
    const Picture& picture = session.picture();
    const Dial dial = makeDial(session.model(), picture, picture.event ? &*picture.event : nullptr);
    heading(context, "Dial",
            dial.empty() ? "" : "tangent plane at p " + std::to_string(dial.pivot));
    if (dial.empty()) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextDisabled("%s", session.atEnd() ? "No pivot here: the run is finished."
                                                  : "No pivot here. Step on: F11 or \xE2\x86\x92.");
        ImGui::PopTextWrapPos();
        return;
    }
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const std::vector<std::string> caption = wrapped(dial.caption, room.x);
    const float captionHeight = ImGui::GetTextLineHeightWithSpacing() *
                                static_cast<float>(std::max<std::size_t>(1, caption.size()));
    // In a low panel one scrolls.
    const float least = std::min(9.0F * context.em, room.x);
    const float height = std::max(std::min(room.y - captionHeight, room.x), least);
    const Disc disc = discIn({{corner.x, corner.y}, {room.x, height}}, context, dial);
    if (disc.radius < 2.0F * context.em) return;
    ImGui::InvisibleButton("##dial", {room.x, height});
    DialDrawer drawer(context, dial, disc);
    drawer.draw({{corner.x, corner.y}, {room.x, height}});
    if (dial.reciprocal) {
        const float small = 0.3F * disc.radius;
        drawReciprocal(context, *dial.reciprocal,
                       {{corner.x + room.x - small - 0.2F * context.em,
                         corner.y + height - small - 0.2F * context.em},
                        small});
    }
    if (ImGui::IsItemHovered()) {
        const DialTick* tick = drawer.underPointer();
        if (tick != nullptr) context.ui().pointedAt = tick->point;
        if (tick != nullptr) explain(context, *tick);
        if (tick != nullptr && ImGui::IsItemClicked()) session.select(tick->point);
    }
    for (const std::string& line : caption) {
        const float width = ImGui::CalcTextSize(line.c_str()).x;
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, 0.5F * (room.x - width)));
        ImGui::TextUnformatted(line.c_str());
    }
}

}  // namespace se::view
