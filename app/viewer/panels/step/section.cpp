// The Section panel: the plane along the normal through the pivot and the tested point, drawn flat,
// with the outer side up. It is turned about the normal by a drag, or by a key.
#include "rows/normal_section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "panel_state/side_panels.h"
#include "panels/widgets/widgets.h"
#include "scene/draw_list.h"
#include "session/session.h"

namespace se::view {

namespace {

/// Degrees of turn for a drag over an em.
constexpr float kTurnPerEm = 6.0F;
/// Width of the picture relative to its height, at most: a profile is flat.
constexpr float kFlattest = 1.6F;
/// Size of a name, in em.
constexpr float kSectionName = 0.8F;

/// Look of a point, by its role.
struct SectionLook {
    Shape shape;
    Color Palette::*color;
};
SectionLook sectionLook(const SectionPoint& point) {
    switch (point.role) {
        case DialRole::Neighbor:
            return {Shape::Circle, &Palette::unused};
        case DialRole::Done:
            return {Shape::Dot, &Palette::done};
        case DialRole::Candidate:
            return {Shape::Disc, point.underTest ? &Palette::test : &Palette::used};
        case DialRole::Rejected:
            return {Shape::Cross, &Palette::rejected};
        case DialRole::First:
        case DialRole::Start:
            return {Shape::Forward, &Palette::first};
        case DialRole::Last:
        case DialRole::End:
            return {Shape::Back, &Palette::last};
    }
    return {Shape::Circle, &Palette::unused};
}

/// A section on the screen: the pivot in the middle, the normal up.
class SectionDrawer {
  public:
    SectionDrawer(const PanelContext& context, const NormalSection& section, const Rect& room)
        : c_(context), section_(section), room_(room), list_(ImGui::GetWindowDrawList()) {
        const float side = std::min(room.size.x, kFlattest * room.size.y);
        scale_ = 0.5F * side / static_cast<float>(section.reach);
        middle_ = room.min + 0.5F * room.size;
    }

    void draw() {
        const Palette& colors = c_.palette;
        list_->PushClipRect(toVec2(room_.min), toVec2(room_.max()), true);
        fill(list_, room_, colors.background);
        drawTangent();
        for (const SectionCut& cut : section_.cuts) drawCut(cut);
        if (section_.circle) drawCircle(*section_.circle);
        for (const SectionPoint& point : section_.points) drawPoint(point);
        drawShape(list_, at({0.0, 0.0}), 1.15F * c_.em, Shape::RingedDisc, toU32(colors.pivot));
        addName({0.0, 0.0}, nameOf(section_.pivot, c_.session().names()), colors.pivot);
        for (const SectionPoint& each : section_.points) take(each.at, 0.3F * c_.em);
        for (const SectionCut& cut : section_.cuts) {
            for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
                take(cut.from + share * (cut.to - cut.from), 0.1F * c_.em);
        }
        // Those of the decision first: they get the best places.
        for (const bool tested : {true, false}) {
            for (const SectionPoint& each : section_.points) {
                if (each.underTest == tested && isNamed(each)) addNameOf(each);
            }
        }
        nameTangent();
        list_->PopClipRect();
    }

    const SectionPoint* underPointer() const {
        return nearestToPointer(section_.points, c_.em,
                                [this](const SectionPoint& point) { return at(point.at); });
    }

  private:
    float px(float width) const { return std::max(1.0F, width * c_.em); }
    ImVec2 at(const SectionPlace& place) const {
        return {middle_.x + scale_ * static_cast<float>(place.x),
                middle_.y - scale_ * static_cast<float>(place.y)};
    }
    bool isNamed(const SectionPoint& point) const {
        const bool lit = point.point == c_.session().highlights().hovered();
        return point.underTest || point.named || lit;
    }

    void drawTangent() {
        const float y = middle_.y;
        const ImU32 dim = toU32(c_.palette.textDim);
        constexpr float kDash = 0.5F;
        for (float x = room_.min.x; x < room_.max().x; x += 2.0F * kDash * c_.em)
            list_->AddLine({x, y}, {x + kDash * c_.em, y}, dim, px(0.07F));
        const ImVec2 tip(middle_.x, middle_.y - 0.28F * room_.size.y);
        const float wing = 0.3F * c_.em;
        const ImU32 ink = toU32(c_.palette.pivot.withAlpha(0.8F));
        list_->AddLine({middle_.x, middle_.y}, tip, ink, px(0.09F));
        list_->AddTriangleFilled({tip.x, tip.y - wing}, {tip.x - wing, tip.y + wing},
                                 {tip.x + wing, tip.y + wing}, ink);
        const float size = kSectionName * c_.em;
        const ImVec2 label(tip.x + 0.5F * c_.em, tip.y - 0.5F * size);
        list_->AddText(c_.fonts.text, size, label, dim, "normal");
        taken_.push_back({{label.x, label.y}, {3.0F * c_.em, size}});
    }

    void drawCut(const SectionCut& cut) {
        const Color& color = cut.isNew ? c_.palette.test : c_.palette.textDim;
        list_->AddLine(at(cut.from), at(cut.to), toU32(color), px(0.2F));
    }

    void drawCircle(const SectionCircle& circle) {
        const float radius = scale_ * static_cast<float>(circle.radius);
        const ImVec2 center = at(circle.center);
        list_->AddCircleFilled(center, radius, toU32(c_.palette.test.withAlpha(0.12F)), 128);
        list_->AddCircle(center, radius, toU32(c_.palette.test), 128, px(0.13F));
        drawShape(list_, center, 0.4F * c_.em, Shape::Disc, toU32(c_.palette.test));
    }

    /// Points beside the plane are fainter, the farther the more.
    void drawPoint(const SectionPoint& point) {
        const SectionLook look = sectionLook(point);
        const float off = static_cast<float>(std::abs(point.off) / section_.reach);
        const Color color =
            (c_.palette.*look.color).withAlpha(std::clamp(1.0F - 1.5F * off, 0.4F, 1.0F));
        const bool named = isNamed(point);
        const float size = point.role == DialRole::Done ? 0.4F : named ? 0.8F : 0.5F;
        drawShape(list_, at(point.at), size * c_.em, look.shape, toU32(color));
        if (point.underTest)
            list_->AddCircle(at(point.at), 0.62F * c_.em, toU32(c_.palette.test), 0, px(0.12F));
        if (point.point == c_.session().selected())
            list_->AddCircle(at(point.at), 0.78F * c_.em, toU32(c_.palette.text), 0, px(0.1F));
    }

    void take(const SectionPlace& place, float half) {
        const ImVec2 middle = at(place);
        taken_.push_back({{middle.x - half, middle.y - half}, glm::vec2(2.0F * half)});
    }

    /// At an end of the line, where nothing else is.
    void nameTangent() {
        const float size = kSectionName * c_.em;
        constexpr const char* kText = "tangent plane";
        const ImVec2 extent = c_.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, kText);
        const float inset = 0.4F * c_.em;
        const float left = room_.min.x + inset;
        const float right = room_.max().x - extent.x - inset;
        for (const float below : {0.2F, 1.3F, 2.6F}) {
            const glm::vec2 y = middle_.y + glm::vec2(below * c_.em, -below * c_.em - extent.y);
            for (const glm::vec2& corner : {glm::vec2(left, y.x), glm::vec2(left, y.y),
                                            glm::vec2(right, y.x), glm::vec2(right, y.y)}) {
                if (!isFree({corner, {extent.x, extent.y}})) continue;
                list_->AddText(c_.fonts.text, size, toVec2(corner), toU32(c_.palette.textDim),
                               kText);
                return;
            }
        }
    }

    void addNameOf(const SectionPoint& point) {
        addName(point.at, nameOf(point.point, c_.session().names()),
                point.underTest ? c_.palette.text : c_.palette.*sectionLook(point).color);
    }

    /// Beside its point, in the first direction that is free; omitted if none is.
    void addName(const SectionPlace& place, const std::string& text, const Color& color) {
        const float size = kSectionName * c_.em;
        const ImVec2 extent = c_.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, text.c_str());
        const ImVec2 from = at(place);
        const float gap = 0.75F * c_.em;
        constexpr std::array kWays = {glm::vec2(1, -1),   glm::vec2(-1, -1),  glm::vec2(1, 1),
                                      glm::vec2(-1, 1),   glm::vec2(0, -2),   glm::vec2(0, 2),
                                      glm::vec2(1, -2.5), glm::vec2(-1, -2.5)};
        for (const glm::vec2& way : kWays) {
            const float left = way.x > 0.0F   ? from.x + gap
                               : way.x < 0.0F ? from.x - gap - extent.x
                                              : from.x - 0.5F * extent.x;
            const Rect rect{{left, from.y + way.y * gap - 0.5F * extent.y}, {extent.x, extent.y}};
            if (!isFree(rect)) continue;
            taken_.push_back(rect);
            fill(list_, rect, c_.palette.background.withAlpha(0.75F), 0.15F * c_.em);
            list_->AddText(c_.fonts.text, size, toVec2(rect.min), toU32(color), text.c_str());
            return;
        }
    }

    bool isFree(const Rect& rect) const {
        if (!room_.contains(rect.min) || !room_.contains(rect.max())) return false;
        return std::none_of(taken_.begin(), taken_.end(), [&](const Rect& other) {
            return rect.min.x < other.max().x && other.min.x < rect.max().x &&
                   rect.min.y < other.max().y && other.min.y < rect.max().y;
        });
    }

    const PanelContext& c_;
    const NormalSection& section_;
    Rect room_;
    glm::vec2 middle_{0.0F};
    float scale_ = 1.0F;  ///< Pixels per scene unit.
    ImDrawList* list_;
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
    if (!session.ready()) return;
    SectionPanel& panel = context.state<SectionPanel>();
    panel.shownIn = ImGui::GetFrameCount();
    const NormalSection& section = sectionHere(context);
    dimText(planeText(section, panel.turnDegrees, session.names()));
    if (section.empty()) {
        dimText(session.atEnd() ? "No pivot here: the run is finished."
                                : "No pivot here. Step forward: F11 or \xE2\x86\x92.");
        return;
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
