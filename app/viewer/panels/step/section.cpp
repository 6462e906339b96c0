// The Section panel: the plane along the normal through the pivot and the tested point, drawn flat,
// with the outer side up. It is turned about the normal by a drag, or by a key.
#include "rows/normal_section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "layout/overlays.h"
#include "paint/shapes.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/screen_painter.h"
#include "rows/pivot_dial.h"
#include "session/session.h"

namespace se::view {

namespace {

/// Degrees of turn for a drag over an em.
constexpr float kTurnPerEm = 6.0F;
/// Width of the picture relative to its height, at most: a profile is flat.
constexpr float kFlattest = 1.6F;
/// Size of a name, in em.
constexpr float kSectionName = 0.8F;

/// A section on the screen: the pivot in the middle, the normal up.
class SectionDrawer {
  public:
    SectionDrawer(const PanelContext& context, const NormalSection& section, const Rect& room)
        : c_(context), p_(context), section_(section), room_(room) {
        const float side = std::min(room.size.x, kFlattest * room.size.y);
        scale_ = 0.5F * side / static_cast<float>(section.reach);
        middle_ = room.min + 0.5F * room.size;
    }

    void draw() {
        ImGui::PushClipRect(toVec2(room_.min), toVec2(room_.max()), true);
        p_.box(room_, p_.ink(&Palette::background));
        drawTangent();
        for (const SectionCut& cut : section_.cuts)
            p_.line(at(cut.from), at(cut.to),
                    line(cut.isNew ? &Palette::test : &Palette::textDim, 0.2F));
        if (section_.circle) drawCircle(*section_.circle);
        for (const SectionPoint& point : section_.points) drawPoint(point);
        drawShape(p_, middle_, 1.15F * c_.em, Shape::RingedDisc, p_.ink(&Palette::pivot));
        addName(middle_, section_.pivot, &Palette::pivot);
        for (const SectionPoint& each : section_.points) take(each.at, 0.3F * c_.em);
        for (const SectionCut& cut : section_.cuts) {
            for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
                take(cut.from + share * (cut.to - cut.from), 0.1F * c_.em);
        }
        // Those of the decision first: they get the best places.
        for (const bool tested : {true, false}) {
            for (const SectionPoint& each : section_.points) {
                if (each.underTest == tested && isNamed(each))
                    addName(at(each.at), each.point,
                            tested ? &Palette::text : lookOf(each.role).color);
            }
        }
        nameTangent();
        ImGui::PopClipRect();
    }

    const SectionPoint* underPointer() const {
        return nearestToPointer(section_.points, c_.em,
                                [this](const SectionPoint& point) { return at(point.at); });
    }

  private:
    Ink line(Color Palette::*color, float ems) const { return p_.ink(color).line(p_.px(ems)); }
    glm::vec2 at(const SectionPlace& place) const {
        return middle_ + scale_ * glm::vec2(place.x, -place.y);
    }
    bool isNamed(const SectionPoint& point) const {
        const bool lit = point.point == c_.session().highlights().hovered();
        return point.underTest || point.named || lit;
    }

    void drawTangent() {
        constexpr float kDash = 0.5F;
        for (float x = room_.min.x; x < room_.max().x; x += 2.0F * kDash * c_.em)
            p_.line({x, middle_.y}, {x + kDash * c_.em, middle_.y}, line(&Palette::textDim, 0.07F));
        const glm::vec2 tip = middle_ - glm::vec2(0.0F, 0.28F * room_.size.y);
        const float wing = 0.3F * c_.em;
        const Ink ink = p_.ink(&Palette::pivot, 0.8F);
        p_.line(middle_, tip, ink.line(p_.px(0.09F)));
        p_.polygon({tip + wing * glm::vec2(0.0F, -1.0F), tip + wing * glm::vec2(1.0F, 1.0F),
                    tip + wing * glm::vec2(-1.0F, 1.0F)},
                   ink);
        const glm::vec2 label = tip + glm::vec2(0.5F * c_.em, -0.5F * type_.size);
        p_.text(label, "normal", p_.ink(&Palette::textDim), type_);
        taken_.push_back({label, {3.0F * c_.em, type_.size}});
    }

    void drawCircle(const SectionCircle& circle) {
        const float radius = scale_ * static_cast<float>(circle.radius);
        const glm::vec2 center = at(circle.center);
        p_.circle(center, radius, p_.ink(&Palette::test, 0.12F));
        p_.circle(center, radius, line(&Palette::test, 0.13F));
        drawShape(p_, center, 0.4F * c_.em, Shape::Disc, p_.ink(&Palette::test));
    }

    /// Points beside the plane are fainter, the farther the more.
    void drawPoint(const SectionPoint& point) {
        const float off = static_cast<float>(std::abs(point.off) / section_.reach);
        const Ink ink =
            p_.ink(colorOf(point.role, point.underTest), std::clamp(1.0F - 1.5F * off, 0.4F, 1.0F));
        const float size = point.role == DialRole::Done ? 0.4F : isNamed(point) ? 0.8F : 0.5F;
        const glm::vec2 place = at(point.at);
        drawShape(p_, place, size * c_.em, lookOf(point.role).shape, ink);
        if (point.underTest) p_.circle(place, 0.62F * c_.em, line(&Palette::test, 0.12F));
        if (point.point == c_.session().selected())
            p_.circle(place, 0.78F * c_.em, line(&Palette::text, 0.1F));
    }

    void take(const SectionPlace& place, float half) {
        taken_.push_back({at(place) - half, glm::vec2(2.0F * half)});
    }

    /// Names the tangent plane at an end of its line, where nothing else is.
    void nameTangent() {
        const std::string text = "tangent plane";
        const glm::vec2 extent = p_.textSize(text, type_);
        const float inset = 0.4F * c_.em;
        for (const float below : {0.2F, 1.3F, 2.6F}) {
            for (const float x : {room_.min.x + inset, room_.max().x - extent.x - inset}) {
                for (const float y :
                     {middle_.y + below * c_.em, middle_.y - below * c_.em - extent.y}) {
                    if (isFree({{x, y}, extent}))
                        return p_.text({x, y}, text, p_.ink(&Palette::textDim), type_);
                }
            }
        }
    }

    /// Names a point, in the first direction from it that is free; omitted if none is.
    void addName(glm::vec2 from, Index point, Color Palette::*color) {
        const std::string text = nameOf(point, c_.session().names());
        const glm::vec2 extent = p_.textSize(text, type_);
        const float gap = 0.75F * c_.em;
        constexpr std::array kWays = {glm::vec2(1, -1),   glm::vec2(-1, -1),  glm::vec2(1, 1),
                                      glm::vec2(-1, 1),   glm::vec2(0, -2),   glm::vec2(0, 2),
                                      glm::vec2(1, -2.5), glm::vec2(-1, -2.5)};
        for (const glm::vec2& way : kWays) {
            const glm::vec2 half(0.5F * (1.0F - way.x) * extent.x, 0.5F * extent.y);
            const Rect rect{from + gap * way - half, extent};
            if (!isFree(rect)) continue;
            taken_.push_back(rect);
            p_.box(rect, p_.ink(&Palette::background, 0.75F), 0.15F * c_.em);
            return p_.text(rect.min, text, p_.ink(color), type_);
        }
    }

    bool isFree(const Rect& rect) const {
        return within(rect, room_) &&
               std::none_of(taken_.begin(), taken_.end(),
                            [&](const Rect& other) { return overlap(rect, other); });
    }

    const PanelContext& c_;
    ScreenPainter p_;
    const NormalSection& section_;
    Rect room_;
    glm::vec2 middle_{0.0F};
    float scale_ = 1.0F;  ///< Pixels per scene unit.
    Type type_{kSectionName * c_.em};
    std::vector<Rect> taken_;  ///< Names so far.
};

/// The section at the cursor; computed again only after a change.
const NormalSection& sectionHere(const PanelContext& context) {
    SectionPanel& panel = context.state<SectionPanel>();
    const Session& session = context.session();
    const SectionInputs now{session.generation(), session.revision(), panel.turnDegrees};
    if (panel.inputs == now) return panel.made;
    const DecisionState& picture = session.picture();
    const std::span<const Triangle> shown = session.shownTriangles();
    const std::size_t finished = std::min(picture.finishedTriangles, shown.size());
    panel.made = makeSection(session.shown(), picture,
                             picture.repaired ? shown : shown.first(finished), panel.turnDegrees);
    panel.inputs = now;
    return panel.made;
}

void turnByDrag(SectionPanel& panel, float em) {
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        panel.turnDegrees = 0.0;
    else if (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0.0F)
        panel.turn(double{kTurnPerEm / em * ImGui::GetIO().MouseDelta.x});
}

std::string planeText(const NormalSection& section, double turnDegrees,
                      std::span<const PointName> names) {
    if (section.empty()) return {};
    if (turnDegrees != 0.0) return formatted("turned %.0f\xC2\xB0", turnDegrees);
    return section.through == kNone ? "" : "through " + nameOf(section.through, names);
}

}  // namespace

void drawSection(const PanelContext& context) {
    Session& session = context.session();
    SectionPanel& panel = context.state<SectionPanel>();
    panel.shownIn = ImGui::GetFrameCount();
    const NormalSection& section = sectionHere(context);
    dimText(planeText(section, panel.turnDegrees, session.names()));
    if (section.empty()) {
        return dimText(noPivotText(session));
    }
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const Rect area{{corner.x, corner.y},
                    {std::max(room.x, context.em), std::max(0.6F * room.x, 8.0F * context.em)}};
    ImGui::InvisibleButton("##section", toVec2(area.size));
    nameItem(context, "section");
    SectionDrawer drawer(context, section, area);
    drawer.draw();
    if (ImGui::IsItemHovered()) {
        if (const SectionPoint* point = drawer.underPointer()) {
            context.state<Navigation>().pointedAt = point->point;
            showTooltip("point " + std::to_string(point->point) +
                        formatted(": height %+.4g, %.4g beside the plane", point->at.y,
                                  std::abs(point->off)));
        } else if (!ImGui::IsItemActive()) {
            showTooltip("Drag: turn the plane about the normal (" +
                        context.key("view.section.turn") + "). Double click: turn it back.");
        }
    }
    turnByDrag(panel, context.em);
}

}  // namespace se::view
