// The tangent plane of the pivot as a disc: each neighbor is a tick at its angle, with a stem for
// its height above the plane; sectors, arcs and the chord are the thresholds of the current rule.
// Names stand around the rim; those of the most important points are placed first, and none covers
// another.
#include "dial_painter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "layout/overlays.h"
#include "shapes.h"

namespace se::view {

// Names are placed in the order of their importance. Each tries its own angle, then angles to both
// sides in growing steps, then the same in a second row outward; the first free position is taken.

namespace {

/// Disc and names about the origin.
Rect boundsOf(float radius, std::span<const DialName> names, float gap, float margin) {
    glm::vec2 low(-radius - margin);
    glm::vec2 high(radius + margin);
    for (const DialName& name : names) {
        const glm::vec2 corner = nameCorner(DialCircle{{}, radius}.at(name.degrees), name, gap);
        low = glm::min(low, corner);
        high = glm::max(high, corner + name.extent);
    }
    return {low, high - low};
}

/// Limit and step of moving a name along the rim, in degrees.
constexpr int kFarthest = 48;
constexpr int kStep = 2;
/// Distance from which a line leads back to the rim.
constexpr int kLeaderFromRow = 5;
/// Maximum reach of the corner of a name over the rim, as a share of the gap.
constexpr float kTouch = 0.4F;

class NamePlacer {
  public:
    NamePlacer(const DialCircle& disc, const NameRoom& room) : disc_(disc), room_(room) {
        taken_.assign(room.taken.begin(), room.taken.end());
    }

    std::optional<PlacedName> place(const DialName& name) {
        for (int row = 0; row < 2; ++row) {
            for (int off = 0; off <= kFarthest; off += kStep) {
                for (const int side : {1, -1}) {
                    const std::optional<Rect> rect = freeAt(name, side * off, row);
                    if (!rect) continue;
                    taken_.push_back(*rect);
                    return PlacedName{0, *rect, row > 0 || off >= kLeaderFromRow};
                }
            }
        }
        return std::nullopt;
    }

  private:
    std::optional<Rect> freeAt(const DialName& name, int off, int row) const {
        const double degrees = name.degrees + off;
        const float gap = room_.gap + static_cast<float>(row) * room_.line;
        const Rect rect{nameCorner(disc_.at(degrees), {degrees, name.extent}, gap), name.extent};
        // Half a pixel: the disc was made as large as the names allow.
        const bool inside = within(rect, room_.area, 0.5F);
        // Moved along the rim a long name may reach into the disc; its corner touches it anyway.
        const LabelMark filled{disc_.center, disc_.radius - kTouch * room_.gap};
        if (!inside || overlap(rect, filled)) return std::nullopt;
        for (const Rect& other : taken_) {
            if (overlap(rect, other)) return std::nullopt;
        }
        return rect;
    }

    const DialCircle& disc_;
    const NameRoom& room_;
    std::vector<Rect> taken_;
};

}  // namespace

glm::vec2 nameCorner(glm::vec2 rim, const DialName& name, float gap) {
    const float a = glm::radians(static_cast<float>(name.degrees));
    return {rim.x + gap * std::cos(a) + 0.5F * name.extent.x * (std::cos(a) - 1.0F),
            rim.y - gap * std::sin(a) - 0.5F * name.extent.y * (std::sin(a) + 1.0F)};
}

DialCircle fitDial(const Rect& room, std::span<const DialName> names, float gap, float margin) {
    float least = 0.0F;
    float most = 0.5F * std::min(room.size.x, room.size.y);
    // The bounds grow with the radius.
    for (int i = 0; i < 12; ++i) {
        const float radius = 0.5F * (least + most);
        const Rect bounds = boundsOf(radius, names, gap, margin);
        const bool fits = bounds.size.x <= room.size.x && bounds.size.y <= room.size.y;
        (fits ? least : most) = radius;
    }
    const Rect bounds = boundsOf(least, names, gap, margin);
    return {room.min + 0.5F * (room.size - bounds.size) - bounds.min, least};
}

std::vector<PlacedName> placeNames(const DialCircle& disc, const NameRoom& room,
                                   std::span<const DialName> names) {
    NamePlacer placer(disc, room);
    std::vector<PlacedName> placed;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::optional<PlacedName> found = placer.place(names[i]);
        if (!found) continue;
        found->name = i;
        placed.push_back(*found);
    }
    return placed;
}

namespace {

// ---- looks ----------------------------------------------------------------------------------

/// Look of a part of the full turn.
struct DialArcLook {
    float reach;  ///< Radius of the sector and of the line, in radii of the disc.
    Color Palette::*color;
    float fill = 0.0F;   ///< Opacity of the sector; 0: none.
    float width = 0.0F;  ///< Of the line, in em; 0: none.
    bool dashed = false;
};

const DialArcLook& lookOf(DialArc::Kind kind) {
    static constexpr std::array<DialArcLook, 6> kLooks = {{
        {1.0F, &Palette::pivot, 0.15F, 0.16F},
        {1.05F, &Palette::textDim, 0.0F, 0.1F, true},
        {0.5F, &Palette::test, 0.0F, 0.22F},
        {0.5F, &Palette::rejected, 0.0F, 0.22F, true},
        {0.9F, &Palette::test, 0.3F},
        {0.4F, &Palette::test, 0.0F, 0.16F},
    }};
    static_assert(static_cast<std::size_t>(DialArc::Kind::Angle) + 1 == kLooks.size());
    return kLooks[static_cast<std::size_t>(kind)];
}

/// True for a neighbor that is no candidate: it is drawn small, without a spoke.
bool isFaint(const DialTick& tick) {
    return tick.role == DialRole::Neighbor || tick.role == DialRole::Done;
}

/// Width of a neighbor's mark, in em.
float sizeOf(const DialTick& tick) {
    if (tick.role == DialRole::Done) return 0.4F;
    return isFaint(tick) ? 0.5F : 0.72F;
}

// ---- the rim and its texts ------------------------------------------------------------------

/// Distance between the rim and a name, in em, and the size of a name.
constexpr float kNameGap = 0.45F;
constexpr float kNameSize = 0.8F;

/// Text at the rim.
struct RimText {
    double degrees = 0.0;
    std::string text;
    Color Palette::*color = &Palette::text;
};

std::vector<DialName> namesOf(const Painter& painter, std::span<const RimText> texts) {
    std::vector<DialName> names;
    for (const RimText& each : texts)
        names.push_back({each.degrees, painter.textSize(each.text, {kNameSize * painter.em()})});
    return names;
}

DialCircle discWithTexts(const Painter& painter, const Rect& room, std::span<const RimText> texts) {
    const float em = painter.em();
    return fitDial(room, namesOf(painter, texts), kNameGap * em, 0.35F * em);
}

/// Draws texts around the rim, none over another; the first in the list are closest to their
/// points. `taken`: areas without texts.
void drawRimTexts(Painter& painter, const DialCircle& disc, const Rect& room,
                  std::span<const Rect> taken, std::span<const RimText> texts) {
    const float em = painter.em();
    const float size = kNameSize * em;
    const NameRoom around{room, taken, kNameGap * em, 1.15F * size};
    for (const PlacedName& each : placeNames(disc, around, namesOf(painter, texts))) {
        const RimText& text = texts[each.name];
        const glm::vec2 rim = disc.at(text.degrees);
        if (each.leader)
            painter.line(rim, nearestIn(each.rect, rim),
                         painter.ink(text.color, 0.7F).line(painter.px(0.05F)));
        // A stem may run behind it.
        painter.box(each.rect, painter.ink(&Palette::panel, 0.8F), 0.15F * em);
        painter.text({each.rect.min.x + 0.5F * each.rect.size.x, each.rect.min.y}, text.text,
                     painter.ink(text.color), {size, Typeface::Text, Align::Middle});
    }
}

// ---- the disc -------------------------------------------------------------------------------

/// The dial of the pivot.
class DialPainter {
  public:
    DialPainter(Painter& painter, const DialPicture& picture, const DialCircle& disc,
                const Rect& room)
        : p_(painter), picture_(picture), dial_(picture.dial), disc_(disc), room_(room) {}

    void draw(std::span<const Rect> taken) {
        p_.circle(disc_.center, disc_.radius, p_.ink(&Palette::background));
        for (const DialArc& arc : dial_.arcs) drawArc(arc);
        for (const DialSlot& slot : dial_.slots) drawSlot(slot);
        if (dial_.chord) drawChord(*dial_.chord);
        p_.circle(disc_.center, disc_.radius, line(&Palette::border, 0.08F));
        for (const DialTick& tick : dial_.ticks) drawTick(tick);
        p_.setPoint(dial_.pivot);
        drawShape(p_, disc_.center, 1.15F * p_.em(), Shape::RingedDisc, p_.ink(&Palette::pivot));
        p_.setPoint(kNone);
        for (const DialMark& mark : dial_.marks)
            p_.line(disc_.at(mark.degrees, 0.86F), disc_.at(mark.degrees, 1.05F),
                    line(&Palette::textDim, 0.14F));
        drawRimTexts(p_, disc_, room_, taken, texts());
    }

  private:
    Ink line(Color Palette::*color, float ems, float alpha = 1.0F) const {
        return p_.ink(color, alpha).line(p_.px(ems));
    }

    void drawArc(const DialArc& arc) {
        const DialArcLook& look = lookOf(arc.kind);
        const float radius = look.reach * disc_.radius;
        if (look.fill > 0.0F)
            p_.arc(disc_.center, radius, arc.from, arc.to, p_.ink(look.color, look.fill));
        if (look.width == 0.0F) return;
        // The line around a sector is a little fainter.
        const Ink ink = line(look.color, look.width, look.fill > 0.0F ? 0.9F : 1.0F);
        if (!look.dashed) return p_.arc(disc_.center, radius, arc.from, arc.to, ink);
        const int parts = std::max(2, static_cast<int>((arc.to - arc.from) / 4.0));
        const double dash = (arc.to - arc.from) / parts;
        for (int i = 0; i < parts; i += 2)
            p_.arc(disc_.center, radius, arc.from + dash * i, arc.from + dash * (i + 1), ink);
    }

    /// The plane of §6.2 seen from above: the far side of the chord is hatched.
    void drawChord(const DialChord& chord) {
        constexpr int kLines = 12;
        const double middle = 0.5 * (chord.from + chord.to);
        const double half = 0.5 * (chord.to - chord.from);
        for (int i = 1; i < kLines; ++i) {
            const double degrees = chord.from + (chord.to - chord.from) * i / kLines;
            const double reach =
                std::cos(glm::radians(half)) / std::cos(glm::radians(degrees - middle));
            p_.line(disc_.at(degrees, static_cast<float>(reach)), disc_.at(degrees),
                    line(&Palette::rejected, 0.06F, 0.6F));
        }
        p_.line(disc_.at(chord.from), disc_.at(chord.to), line(&Palette::rejected, 0.14F));
    }

    /// A neighbor on the ring beside the pivot, filled if the third point is there.
    void drawSlot(const DialSlot& slot) {
        const glm::vec2 half(0.45F * p_.em());
        const glm::vec2 at = disc_.at(slot.degrees, 0.78F);
        p_.box(at - half, at + half,
               slot.filled ? p_.ink(&Palette::test) : line(&Palette::test, 0.1F));
    }

    /// Refused points are hatched at the rim: the reason is in the tooltip and the caption.
    void drawRefusal(const DialTick& tick, const Ink& ink) {
        for (int i = -2; i <= 2; ++i) {
            const double degrees = tick.degrees + 2.2 * i;
            p_.line(disc_.at(degrees - 2.0, 0.93F), disc_.at(degrees + 2.0),
                    ink.line(p_.px(0.06F)));
        }
    }

    /// The height above the plane: up is the outer side. A height that exceeds the panel ends in an
    /// arrow head instead of a bar.
    void drawStem(const DialTick& tick, glm::vec2 at, const Ink& full) {
        const float stem = tick.height * disc_.radius;
        const float em = p_.em();
        if (std::abs(stem) <= 0.2F * em) return;
        const float low = room_.min.y + 0.1F * em;
        const float top = std::clamp(at.y - stem, low, std::max(low, room_.max().y - 0.1F * em));
        const float wing = 0.2F * em;
        const Ink ink = full.withAlpha(0.8F);
        const Ink line = ink.line(p_.px(0.07F));
        p_.line(at, {at.x, top}, line);
        if (top == at.y - stem) return p_.line({at.x - wing, top}, {at.x + wing, top}, line);
        const float back = top + (stem > 0.0F ? 2.0F : -2.0F) * wing;
        p_.polygon({{at.x, top}, {at.x + wing, back}, {at.x - wing, back}}, ink);
    }

    void drawTick(const DialTick& tick) {
        const Ink ink = p_.ink(colorOf(tick.role, tick.underTest));
        const glm::vec2 at = placeOf(tick, disc_);
        const float em = p_.em();
        const bool rejected = tick.role == DialRole::Rejected;
        if (!isFaint(tick))
            p_.line(
                disc_.center, at,
                ink.withAlpha(rejected ? 0.45F : 0.9F).line(p_.px(tick.underTest ? 0.14F : 0.08F)));
        drawStem(tick, at, ink);
        p_.setPoint(tick.point);
        drawShape(p_, at, sizeOf(tick) * em, lookOf(tick.role).shape, ink);
        if (tick.underTest) p_.circle(at, 0.62F * em, line(&Palette::test, 0.12F));
        p_.setPoint(kNone);
        if (rejected) drawRefusal(tick, ink);
        if (tick.passed) {
            const double half = glm::degrees(0.15F * em / disc_.radius);
            p_.arc(disc_.center, 0.97F * disc_.radius, tick.degrees - half, tick.degrees + half,
                   ink.line(0.06F * disc_.radius));
        }
        if (tick.rank > 0) drawRank(tick);
        if (tick.point == picture_.hovered || tick.point == picture_.selected)
            p_.circle(at, 0.78F * em, line(&Palette::text, 0.1F));
    }

    /// The texts at the rim, the most important first: these are closest to their points.
    std::vector<RimText> texts() const {
        std::vector<RimText> first;
        std::vector<RimText> ends;
        std::vector<RimText> others;
        for (const DialTick& tick : dial_.ticks) {
            const bool lit = tick.underTest || tick.point == picture_.hovered;
            if (isFaint(tick) && !lit) continue;
            (lit          ? first
             : tick.named ? ends
                          : others)
                .push_back({tick.degrees, labelOf(tick, picture_.names),
                            lit ? &Palette::text : lookOf(tick.role).color});
        }
        for (const DialSlot& slot : dial_.slots)
            first.push_back({slot.degrees, slot.text, &Palette::test});
        for (const DialMark& mark : dial_.marks)
            ends.push_back({mark.degrees, mark.text, &Palette::textDim});
        first.insert(first.end(), ends.begin(), ends.end());
        first.insert(first.end(), others.begin(), others.end());
        return first;
    }

    /// Draws the rank along the spoke, clear of the marks and ranks of other points; omitted if
    /// there is no such position.
    void drawRank(const DialTick& tick) {
        const float em = p_.em();
        for (const float part : {0.5F, 0.65F, 0.38F, 0.78F, 0.28F}) {
            const glm::vec2 at = disc_.at(tick.degrees, part * std::max(0.12F, tick.reach));
            const glm::vec2 middle = at + glm::vec2(0.3F, 0.4F) * em;
            const bool clear =
                glm::distance(middle, disc_.center) >= 0.8F * em &&
                std::none_of(dial_.ticks.begin(), dial_.ticks.end(),
                             [&](const DialTick& other) {
                                 return glm::distance(middle, placeOf(other, disc_)) < 0.8F * em;
                             }) &&
                std::none_of(ranks_.begin(), ranks_.end(), [&](glm::vec2 other) {
                    return glm::distance(at, other) < 0.85F * em;
                });
            if (!clear) continue;
            ranks_.push_back(at);
            return p_.text(at, std::to_string(tick.rank) + ".", p_.ink(&Palette::text),
                           {0.75F * em});
        }
    }

    Painter& p_;
    const DialPicture& picture_;
    const Dial& dial_;
    DialCircle disc_;
    Rect room_;
    std::vector<glm::vec2> ranks_;  ///< Those so far.
};

}  // namespace

DialCircle discOf(const Painter& painter, const DialPicture& picture, const Rect& room) {
    std::vector<RimText> texts;
    for (const DialTick& tick : picture.dial.ticks) {
        if (tick.role != DialRole::Done)
            texts.push_back({tick.degrees, labelOf(tick, picture.names)});
    }
    for (const DialMark& mark : picture.dial.marks) texts.push_back({mark.degrees, mark.text});
    return discWithTexts(painter, room, texts);
}

void drawDialDisc(Painter& painter, const DialPicture& picture, const DialCircle& disc,
                  const Rect& room, std::span<const Rect> taken) {
    DialPainter(painter, picture, disc, room).draw(taken);
}

void drawDialFigure(Painter& painter, const DialPicture& picture, const Rect& area) {
    // In em: margin, height of the heading, and of the caption.
    constexpr float kMargin = 0.7F;
    constexpr float kHeading = 2.4F;
    constexpr float kCaption = 2.0F;
    if (picture.dial.empty()) return;
    const float em = painter.em();
    Rect room{area.min + glm::vec2(kMargin, kHeading) * em,
              area.size - glm::vec2(2.0F * kMargin, kHeading + kCaption) * em};
    room.size.y = std::min(room.size.y, 1.1F * room.size.x);
    painter.box(area, painter.ink(&Palette::panel));
    drawDialDisc(painter, picture, discOf(painter, picture, room), room);
    painter.text(area.min + glm::vec2(kMargin, 0.5F) * em,
                 "Tangent plane at " + nameOf(picture.dial.pivot, picture.names),
                 painter.ink(&Palette::textDim), {em});
    painter.text({area.min.x + 0.5F * area.size.x, room.max().y + 0.6F * em}, picture.dial.caption,
                 painter.ink(&Palette::text), {em, Typeface::Text, Align::Middle});
}

glm::vec2 placeOf(const DialTick& tick, const DialCircle& disc) {
    return disc.at(tick.degrees, 0.92F * std::max(0.12F, tick.reach));
}

void drawReciprocalDial(Painter& painter, const DialPicture& picture, const Rect& room) {
    assert(picture.dial.reciprocal);
    const DialReciprocal& r = *picture.dial.reciprocal;
    const float em = painter.em();
    const Type type{kNameSize * em, Typeface::Text, Align::Middle};
    const std::string title = "seen from " + nameOf(r.e, picture.names);
    const glm::vec2 line(0.0F, painter.textSize(title, type).y);
    const Rect below{room.min + line, room.size - line};
    Color Palette::*verdict = r.kept ? &Palette::used : &Palette::rejected;
    const std::vector<RimText> texts = {
        {r.firstDegrees(), nameOf(r.first, picture.names), &Palette::first},
        {r.lastDegrees(), nameOf(r.last, picture.names), &Palette::last},
        {r.pivotDegrees, nameOf(picture.dial.pivot, picture.names), verdict}};
    // Room is reserved for a name that moves along the rim.
    const glm::vec2 spare = 0.8F * line;
    const DialCircle disc =
        discWithTexts(painter, {below.min + spare, below.size - 2.0F * spare}, texts);
    if (disc.radius < 0.7F * em) return;
    const float stroke = painter.px(0.08F);
    painter.circle(disc.center, disc.radius, painter.ink(&Palette::background));
    painter.arc(disc.center, disc.radius, 0.0, r.limitDegrees, painter.ink(&Palette::test, 0.25F));
    painter.circle(disc.center, disc.radius, painter.ink(&Palette::border).line(stroke));
    for (const RimText& limit : std::span(texts).first(2))
        painter.line(disc.center, disc.at(limit.degrees), painter.ink(limit.color).line(stroke));
    const glm::vec2 at = disc.at(r.pivotDegrees, 0.9F);
    painter.line(disc.center, at, painter.ink(verdict).line(1.5F * stroke));
    drawShape(painter, at, 0.6F * em, r.kept ? Shape::Disc : Shape::Cross, painter.ink(verdict));
    drawShape(painter, disc.center, 0.6F * em, Shape::RingedDisc, painter.ink(&Palette::test));
    drawRimTexts(painter, disc, below, {}, texts);
    painter.text({room.min.x + 0.5F * room.size.x, room.min.y}, title,
                 painter.ink(&Palette::textDim), type);
}

}  // namespace se::view
