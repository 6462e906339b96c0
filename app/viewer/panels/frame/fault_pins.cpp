// The pins of places with faults that are too small to be seen.
#include <algorithm>
#include <string>

#include "document/alert_actions.h"
#include "panels/widgets/screen_painter.h"
#include "run/model.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// On a head of this strength a text in the color of the background can be read.
constexpr float kReadableFrom = 0.6F;

Type pinType(const PanelContext& context) {
    return {0.9F * context.em, Typeface::Strong, Align::Middle};
}

/// "3 places, first place 4: 1 hole of 3 edges."
std::string tipOf(const Pin& pin, const RunFailureSearch& found) {
    return (pin.count == 1 ? "Place " : withS(pin.count, "place") + ", the most severe: place ") +
           grouped(pin.place + 1) + ", " + describe(found.places[pin.place], found.all) +
           ".\nClick to show it.";
}

void drawHead(const PanelContext& context, const FaultPin& each) {
    const float em = context.em;
    ScreenPainter p(context);
    const float alpha = each.hovered ? 1.0F : each.pin.strength;
    const Rect& head = each.head;
    const glm::vec2 foot(each.pin.tip.x, std::clamp(each.pin.tip.y, head.min.y, head.max().y));
    const float line = std::max(1.5F, 0.12F * em);
    const Ink ink = p.ink(&Palette::rejected, alpha);
    // With a rim of the background, so that it stands out from loops of the same color.
    const Ink rim = p.ink(&Palette::background, alpha);
    p.line(each.pin.tip, foot, rim.line(3.0F * line));
    p.line(each.pin.tip, foot, ink.line(line));
    const float round = 0.5F * head.size.y;
    p.box(head.min - line, head.max() + line, rim, round + line);
    p.box(head, ink, round);
    if (each.hovered) p.box(head, p.ink(&Palette::text).line(line), round);
    if (each.pin.count == 1) return;
    const Type type = pinType(context);
    p.text({head.min.x + 0.5F * head.size.x,
            std::round(head.min.y + 0.5F * (head.size.y - type.size))},
           std::to_string(each.pin.count),
           p.ink(alpha > kReadableFrom ? &Palette::background : &Palette::rejected), type);
}

}  // namespace

std::vector<FaultPin> offerFaultPins(const PanelContext& context) {
    std::vector<FaultPin> shown;
    const RunFailureSearch* found = context.session().finishedFaults();
    if (context.beside || found == nullptr || !showsFinishedMesh(context.commands)) return shown;
    const Model& model = context.session().model();
    const ScreenProjection projection(context);
    std::vector<PinPlace> places;
    for (const FaultPlace& each : found->places) {
        const glm::vec3 center = model.toView(each.center);
        // Outside of every view where it is behind the eye.
        const glm::vec2 at = projection.at(center).value_or(context.rects.view.min - 1.0F);
        places.push_back({at, projection.pixels(center, sizeOnMesh(model, each))});
    }
    for (const Pin& pin : pinsOf(places, context.rects.view, context.em)) {
        const float width =
            pin.count == 1
                ? 0.0F
                : ScreenPainter(context).textSize(std::to_string(pin.count), pinType(context)).x;
        FaultPin each{pin, headOf(pin, width, context.rects.view, context.em)};
        const std::string name = "pin " + std::to_string(pin.place + 1);
        ImGui::SetCursorScreenPos(toVec2(each.head.min));
        if (ImGui::InvisibleButton(("##" + name).c_str(), toVec2(each.head.size)))
            showPlace(context.commands, pin.place);
        each.hovered = ImGui::IsItemHovered();
        nameItem(context, name, each.hovered ? tipOf(pin, *found) : "");
        shown.push_back(each);
    }
    return shown;
}

void drawFaultPins(const PanelContext& context, std::span<const FaultPin> pins) {
    // The most severe last, on top.
    for (auto each = pins.rbegin(); each != pins.rend(); ++each) drawHead(context, *each);
}

}  // namespace se::view
