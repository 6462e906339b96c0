// The axes on a plate: a disc with a letter at each positive end, an open one at each negative end.
#include "axis_gizmo.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "layout/overlays.h"
#include "scene/camera.h"
#include "screen_painter.h"

namespace se::view {

namespace {

/// Sizes in em.
constexpr float kPlate = 5.4F;
constexpr glm::vec2 kLeastRoom{18.0F, 12.0F};
constexpr float kArm = 1.75F;
constexpr float kEnd = 0.62F;
constexpr float kFarEnd = 0.42F;
constexpr std::array kNames = {"x", "y", "z"};
/// Colors of the axes in all programs; softer than those of decisions, and with letters.
constexpr std::array kColors = {fromHex(0xC2504F), fromHex(0x5C9440), fromHex(0x4478C4)};

std::string nameOf(const AxisEnd& end) {
    return (end.positive ? "" : "-") + std::string(kNames[end.axis]);
}

/// The ends, those nearest to the eye first.
std::array<AxisEnd, 6> endsOf(const PanelContext& context, const Rect& plate) {
    const CameraMatrices camera = context.camera().matrices(1.0F);
    const glm::vec2 origin = plate.min + 0.5F * plate.size;
    std::array<AxisEnd, 6> ends;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        AxisEnd& end = ends[i];
        end.axis = i / 2;
        end.positive = i % 2 == 0;
        const float sign = end.positive ? 1.0F : -1.0F;
        const glm::vec3 seen = sign * glm::vec3(camera.view[static_cast<int>(end.axis)]);
        end.at = origin + glm::vec2(seen.x, -seen.y) * (kArm * context.em);
        end.near = seen.z;
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const AxisEnd& a, const AxisEnd& b) { return a.near > b.near; });
    return ends;
}

void drawEnd(const PanelContext& context, const AxisEnd& end, const glm::vec2& origin) {
    const float em = context.em;
    ScreenPainter p(context);
    // What points away from the eye steps back.
    const float share = 0.55F + 0.45F * std::clamp(end.near + 0.6F, 0.0F, 1.0F);
    const Color color = mix(context.palette.panel, kColors[end.axis], share);
    const float radius = (end.positive ? kEnd : kFarEnd) * em;
    if (end.positive) p.line(origin, end.at, Ink(color).line(std::max(1.5F, 0.14F * em)));
    const bool full = end.positive || end.hovered;
    p.circle(end.at, radius, Ink(full ? color : mix(context.palette.panel, color, 0.25F)));
    p.circle(end.at, radius,
             Ink(end.hovered ? context.palette.text : color).line(std::max(1.2F, 0.09F * em)));
    if (!end.positive) return;
    const Type type{0.85F * em, Typeface::Strong, Align::Middle};
    p.text(end.at - glm::vec2(0.0F, 0.54F * type.size), kNames[end.axis],
           p.ink(&Palette::accentText), type);
}

}  // namespace

std::optional<AxisGizmo> offerAxes(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    // In a small view the decision needs the room.
    const glm::vec2 room = context.rects.view.size / em;
    if (room.x < kLeastRoom.x || room.y < kLeastRoom.y) return std::nullopt;
    constexpr std::array kCorners = {Corner::BottomRight, Corner::TopLeft};
    const std::optional<Rect> place =
        freeCorner({context.rects.view, 0.5F * em, taken, {}}, glm::vec2(kPlate * em), kCorners);
    if (!place) return std::nullopt;
    AxisGizmo gizmo{*place, endsOf(context, *place)};
    for (AxisEnd& end : gizmo.ends) {
        const glm::vec2 half(kEnd * em);
        const std::string name = "axis " + nameOf(end);
        ImGui::SetCursorScreenPos(toVec2(end.at - half));
        if (ImGui::InvisibleButton(("##" + name).c_str(), toVec2(2.0F * half))) {
            glm::vec3 from(0.0F);
            from[static_cast<int>(end.axis)] = end.positive ? 1.0F : -1.0F;
            context.camera().faceStraight(from);
        }
        end.hovered = ImGui::IsItemHovered();
        tooltip("Look from " + nameOf(end) + ".");
        context.where()[name] = {end.at - half, 2.0F * half};
    }
    return gizmo;
}

void drawAxes(const PanelContext& context, const AxisGizmo& gizmo) {
    const glm::vec2 origin = gizmo.plate.min + 0.5F * gizmo.plate.size;
    ScreenPainter painter(context);
    painter.circle(origin, 0.5F * gizmo.plate.size.x, painter.ink(&Palette::panel, 0.82F));
    for (auto end = gizmo.ends.rbegin(); end != gizmo.ends.rend(); ++end)
        drawEnd(context, *end, origin);
}

}  // namespace se::view
