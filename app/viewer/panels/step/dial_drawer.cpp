// The tangent plane of the pivot as a disc: each neighbor is a tick at its angle, with a stem for
// its height above the plane; sectors, arcs and the chord are the thresholds of the current rule.
// Names stand around the rim; those of the most important points are placed first, and none covers
// another.
#include "dial_drawer.h"

#include <algorithm>

#include "panels/widgets/widgets.h"
#include "rows/dial_looks.h"
#include "session/session.h"

namespace se::view {

namespace {

// ---- the rim and its texts ------------------------------------------------------------------

/// Distance between the rim and a name, in em, and the size of a name.
constexpr float kNameGap = 0.45F;
constexpr float kNameSize = 0.8F;

/// Size of a text at the rim.
glm::vec2 rimTextSize(const PanelContext& context, const std::string& text) {
    const ImVec2 extent =
        context.fonts.text->CalcTextSizeA(kNameSize * context.em, 1e9F, 0.0F, text.c_str());
    return {extent.x, extent.y};
}

std::vector<DialName> namesOf(const PanelContext& context, std::span<const RimText> texts) {
    std::vector<DialName> names;
    for (const RimText& each : texts) {
        names.push_back({each.degrees, rimTextSize(context, each.text)});
    }
    return names;
}

/// Draws texts around the rim, none over another; the first in the list are closest to their
/// points. `taken`: areas without texts.
void drawRimTexts(const PanelContext& context, const DialDisc& disc, const Rect& room,
                  std::span<const Rect> taken, std::span<const RimText> texts) {
    const float size = kNameSize * context.em;
    const DialCircle place{{disc.center.x, disc.center.y}, disc.radius};
    const NameRoom around{room, taken, kNameGap * context.em, 1.15F * size};
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (const PlacedName& each : placeNames(place, around, namesOf(context, texts))) {
        const RimText& text = texts[each.name];
        if (each.leader) {
            const ImVec2 rim = disc.at(text.degrees, 1.0F);
            list->AddLine(rim, toVec2(nearestIn(each.rect, {rim.x, rim.y})),
                          toU32(text.color.withAlpha(0.7F)), std::max(1.0F, 0.05F * context.em));
        }
        // A stem may run behind it.
        list->AddRectFilled(toVec2(each.rect.min), toVec2(each.rect.max()),
                            toU32(context.palette.panel.withAlpha(0.8F)), 0.15F * context.em);
        list->AddText(context.fonts.text, size, toVec2(each.rect.min), toU32(text.color),
                      text.text.c_str());
    }
}

/// A sector, in parts of at most half a turn: only those are convex.
void fillSector(const DialDisc& disc, double from, double to, float reach, const Color& color) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (double a = from; a < to - 1e-6; a += 180.0) {
        const double b = std::min(a + 180.0, to);
        list->PathLineTo(disc.center);
        list->PathArcTo(disc.center, reach * disc.radius, -static_cast<float>(a) * kDialDegree,
                        -static_cast<float>(b) * kDialDegree, 48);
        list->PathFillConvex(toU32(color));
    }
}

// ---- the disc -------------------------------------------------------------------------------

/// The dial of the pivot.
class DialDrawer {
  public:
    DialDrawer(const PanelContext& context, const Dial& dial, const DialDisc& disc)
        : c_(context), dial_(dial), disc_(disc), list_(ImGui::GetWindowDrawList()) {}

    void draw(const Rect& room, std::span<const Rect> taken) {
        room_ = room;
        const Palette& colors = c_.palette;
        list_->AddCircleFilled(disc_.center, disc_.radius, toU32(colors.background), 96);
        for (const DialArc& arc : dial_.arcs) drawArc(arc);
        for (const DialSlot& slot : dial_.slots) drawSlot(slot);
        if (dial_.chord) drawChord(*dial_.chord);
        list_->AddCircle(disc_.center, disc_.radius, toU32(colors.border), 96, px());
        for (const DialTick& tick : dial_.ticks) drawTick(tick);
        drawShape(list_, disc_.center, 1.15F * c_.em, Shape::RingedDisc, toU32(colors.pivot));
        for (const DialMark& mark : dial_.marks) drawMark(mark);
        drawRimTexts(c_, disc_, room_, taken, texts());
    }

    const DialTick* underPointer() const {
        return nearestToPointer(dial_.ticks, c_.em,
                                [this](const DialTick& tick) { return tip(tick); });
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
        const DialArcLook& look = lookOf(arc.kind);
        const Color& color = c_.palette.*look.color;
        if (look.fill > 0.0F)
            fillSector(disc_, arc.from, arc.to, look.reach, color.withAlpha(look.fill));
        if (look.width == 0.0F) return;
        // The line around a sector is a little fainter.
        strokeArc(arc.from, arc.to, look.reach, look.fill > 0.0F ? color.withAlpha(0.9F) : color,
                  look.width, look.dashed);
    }

    /// The plane of §6.2 seen from above: the far side of the chord is hatched.
    void drawChord(const DialChord& chord) {
        const ImU32 color = toU32(c_.palette.rejected.withAlpha(0.6F));
        constexpr int kLines = 12;
        for (int i = 1; i < kLines; ++i) {
            const double degrees = chord.from + (chord.to - chord.from) * i / kLines;
            const double middle = 0.5 * (chord.from + chord.to);
            const double half = 0.5 * (chord.to - chord.from);
            const auto reach = static_cast<float>(std::cos(half * kDialDegree) /
                                                  std::cos((degrees - middle) * kDialDegree));
            list_->AddLine(disc_.at(degrees, reach), disc_.at(degrees, 1.0F), color, px(0.06F));
        }
        list_->AddLine(disc_.at(chord.from, 1.0F), disc_.at(chord.to, 1.0F),
                       toU32(c_.palette.rejected), px(0.14F));
    }

    void drawMark(const DialMark& mark) {
        list_->AddLine(disc_.at(mark.degrees, 0.86F), disc_.at(mark.degrees, 1.05F),
                       toU32(c_.palette.textDim), px(0.14F));
    }

    /// A neighbor on the ring beside the pivot, filled if the third point is there.
    void drawSlot(const DialSlot& slot) {
        const ImU32 color = toU32(c_.palette.test);
        const float half = 0.45F * c_.em;
        const ImVec2 at = disc_.at(slot.degrees, 0.78F);
        const ImVec2 low(at.x - half, at.y - half);
        const ImVec2 high(at.x + half, at.y + half);
        slot.filled ? list_->AddRectFilled(low, high, color)
                    : list_->AddRect(low, high, color, 0.0F, 0, px(0.1F));
    }

    /// Refused points are hatched at the rim: the reason is in the tooltip and the caption.
    void drawRefusal(const DialTick& tick, ImU32 color) {
        for (int i = -2; i <= 2; ++i) {
            const double degrees = tick.degrees + 2.2 * i;
            list_->AddLine(disc_.at(degrees - 2.0, 0.93F), disc_.at(degrees + 2.0, 1.0F), color,
                           px(0.06F));
        }
    }

    /// The height above the plane: up is the outer side. A height that exceeds the panel ends in an
    /// arrow head instead of a bar.
    void drawStem(const DialTick& tick, const Color& color) {
        const float stem = tick.height * disc_.radius;
        if (std::abs(stem) <= 0.2F * c_.em) return;
        const ImVec2 at = tip(tick);
        const float inset = 0.1F * c_.em;
        const float low = room_.min.y + inset;
        const float top = std::clamp(at.y - stem, low, std::max(low, room_.max().y - inset));
        const float wing = 0.2F * c_.em;
        const ImU32 ink = toU32(color.withAlpha(0.8F));
        list_->AddLine(at, {at.x, top}, ink, px(0.07F));
        if (top == at.y - stem) {
            list_->AddLine({at.x - wing, top}, {at.x + wing, top}, ink, px(0.07F));
            return;
        }
        const float back = top + (stem > 0.0F ? 2.0F : -2.0F) * wing;
        list_->AddTriangleFilled({at.x, top}, {at.x - wing, back}, {at.x + wing, back}, ink);
    }

    /// Names of the points under test, under the pointer and selected.
    void drawRings(const DialTick& tick) {
        const ImVec2 at = tip(tick);
        const bool lit = tick.point == c_.session().highlights().hovered();
        if (tick.underTest) {
            list_->AddCircle(at, 0.62F * c_.em, toU32(c_.palette.test), 0, px(0.12F));
        }
        if (lit || tick.point == c_.session().selected()) {
            list_->AddCircle(at, 0.78F * c_.em, toU32(c_.palette.text), 0, px(0.1F));
        }
    }

    void drawTick(const DialTick& tick) {
        const Color color = c_.palette.*colorOf(tick);
        const ImVec2 at = tip(tick);
        if (!isFaint(tick)) {
            const bool rejected = tick.role == DialRole::Rejected;
            list_->AddLine(disc_.center, at, toU32(color.withAlpha(rejected ? 0.45F : 0.9F)),
                           px(tick.underTest ? 0.14F : 0.08F));
        }
        drawStem(tick, color);
        drawShape(list_, at, sizeOf(tick) * c_.em, lookOf(tick.role).shape, toU32(color));
        if (tick.role == DialRole::Rejected) drawRefusal(tick, toU32(color));
        if (tick.passed) {
            list_->AddLine(disc_.at(tick.degrees, 0.94F), disc_.at(tick.degrees, 1.0F),
                           toU32(color), px(0.3F));
        }
        if (tick.rank > 0) drawRank(tick);
        drawRings(tick);
    }

    /// The most important come first: they are closest to their points.
    std::vector<RimText> texts() const {
        std::vector<RimText> first;
        std::vector<RimText> ends;
        std::vector<RimText> others;
        for (const DialTick& tick : dial_.ticks) {
            const bool lit = tick.underTest || tick.point == c_.session().highlights().hovered();
            if (isFaint(tick) && !lit) continue;
            const RimText text{tick.degrees, labelOf(tick, c_.session().names()),
                               lit ? c_.palette.text : c_.palette.*colorOf(tick)};
            const bool named = tick.named;
            (lit ? first : named ? ends : others).push_back(text);
        }
        for (const DialSlot& slot : dial_.slots)
            first.push_back({slot.degrees, slot.text, c_.palette.test});
        for (const DialMark& mark : dial_.marks)
            ends.push_back({mark.degrees, mark.text, c_.palette.textDim});
        first.insert(first.end(), ends.begin(), ends.end());
        first.insert(first.end(), others.begin(), others.end());
        return first;
    }

    /// Along the spoke, clear of the marks and ranks of other points; omitted if there is
    /// no such position.
    void drawRank(const DialTick& tick) {
        const float em = c_.em;
        const auto isNear = [em](ImVec2 at, ImVec2 other, float reach) {
            return std::hypot(other.x - at.x, other.y - at.y) < reach * em;
        };
        for (const float part : {0.5F, 0.65F, 0.38F, 0.78F, 0.28F}) {
            const ImVec2 at = disc_.at(tick.degrees, part * std::max(0.12F, tick.reach));
            const ImVec2 middle(at.x + 0.3F * em, at.y + 0.4F * em);
            const bool clear = !isNear(middle, disc_.center, 0.8F) &&
                               std::none_of(dial_.ticks.begin(), dial_.ticks.end(),
                                            [&](const DialTick& other) {
                                                return isNear(middle, tip(other), 0.8F);
                                            }) &&
                               std::none_of(ranks_.begin(), ranks_.end(),
                                            [&](ImVec2 other) { return isNear(at, other, 0.85F); });
            if (!clear) continue;
            ranks_.push_back(at);
            const std::string rank = std::to_string(tick.rank) + ".";
            list_->AddText(c_.fonts.text, 0.75F * em, at, toU32(c_.palette.text), rank.c_str());
            return;
        }
    }

    const PanelContext& c_;
    const Dial& dial_;
    DialDisc disc_;
    ImDrawList* list_;
    Rect room_;
    std::vector<ImVec2> ranks_;  ///< Names so far.
};

}  // namespace

DialDisc discWithTexts(const PanelContext& context, const Rect& room,
                       std::span<const RimText> texts) {
    const DialCircle place =
        fitDial(room, namesOf(context, texts), kNameGap * context.em, 0.35F * context.em);
    return {toVec2(place.center), place.radius};
}

void drawDialDisc(const PanelContext& context, const Dial& dial, const DialDisc& disc,
                  const Rect& room, std::span<const Rect> taken) {
    DialDrawer(context, dial, disc).draw(room, taken);
}

const DialTick* tickUnderPointer(const PanelContext& context, const Dial& dial,
                                 const DialDisc& disc) {
    return DialDrawer(context, dial, disc).underPointer();
}

void drawReciprocalDial(const PanelContext& context, const DialReciprocal& r, const Rect& room) {
    const Palette& colors = context.palette;
    const float em = context.em;
    const auto names = context.session().names();
    const std::string title = "seen from " + nameOf(r.e, names);
    const glm::vec2 extent = rimTextSize(context, title);
    const Rect below{room.min + glm::vec2(0.0F, extent.y), room.size - glm::vec2(0.0F, extent.y)};
    const Color& verdict = r.kept ? colors.used : colors.rejected;
    const std::vector<RimText> texts = {
        {r.firstDegrees(), nameOf(r.first, names), colors.first},
        {r.lastDegrees(), nameOf(r.last, names), colors.last},
        {r.pivotDegrees, nameOf(context.session().picture().pivot, names), verdict}};
    // Room is reserved for a name that moves along the rim.
    const glm::vec2 spare(0.0F, 0.8F * extent.y);
    const DialDisc disc =
        discWithTexts(context, {below.min + spare, below.size - 2.0F * spare}, texts);
    if (disc.radius < 0.7F * em) return;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float stroke = std::max(1.0F, 0.08F * em);
    list->AddCircleFilled(disc.center, disc.radius, toU32(colors.background), 48);
    fillSector(disc, 0.0, r.limitDegrees, 1.0F, colors.test.withAlpha(0.25F));
    list->AddCircle(disc.center, disc.radius, toU32(colors.border), 48, stroke);
    list->AddLine(disc.center, disc.at(r.firstDegrees(), 1.0F), toU32(colors.first), stroke);
    list->AddLine(disc.center, disc.at(r.lastDegrees(), 1.0F), toU32(colors.last), stroke);
    const ImVec2 at = disc.at(r.pivotDegrees, 0.9F);
    list->AddLine(disc.center, at, toU32(verdict), 1.5F * stroke);
    drawShape(list, at, 0.6F * em, r.kept ? Shape::Disc : Shape::Cross, toU32(verdict));
    drawShape(list, disc.center, 0.6F * em, Shape::RingedDisc, toU32(colors.test));
    drawRimTexts(context, disc, below, {}, texts);
    list->AddText(context.fonts.text, kNameSize * em,
                  {room.min.x + 0.5F * (room.size.x - extent.x), room.min.y}, toU32(colors.textDim),
                  title.c_str());
}

}  // namespace se::view
