// The pins of places with faults that are too small to be seen.
#include <algorithm>
#include <string>

#include "document/alert_actions.h"
#include "panels/widgets/widgets.h"
#include "run/model.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

/// On a head of this strength a text in the color of the background can be read.
constexpr float kReadableFrom = 0.6F;

float textWidthOf(const PanelContext& context, const Pin& pin) {
    if (pin.count == 1) return 0.0F;
    const std::string text = std::to_string(pin.count);
    return context.fonts.strong->CalcTextSizeA(0.9F * context.em, 1e9F, 0.0F, text.c_str()).x;
}

/// "3 places, first place 4: 1 hole of 3 edges."
std::string tipOf(const Pin& pin, const RunFailureSearch& found) {
    return (pin.count == 1 ? "Place " : withS(pin.count, "place") + ", the most severe: place ") +
           grouped(pin.place + 1) + ", " + describe(found.places[pin.place], found.all) +
           ".\nClick to show it.";
}

void drawHead(const PanelContext& context, const FaultPin& each) {
    const float em = context.em;
    const Palette& colors = context.palette;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float alpha = each.hovered ? 1.0F : each.pin.strength;
    const Rect& head = each.head;
    const glm::vec2 foot(each.pin.tip.x, std::clamp(each.pin.tip.y, head.min.y, head.max().y));
    const float line = std::max(1.5F, 0.12F * em);
    // With a rim of the background, so that it stands out from loops of the same color.
    const ImU32 rim = toU32(colors.background.withAlpha(alpha));
    list->AddLine(toVec2(each.pin.tip), toVec2(foot), rim, 3.0F * line);
    list->AddLine(toVec2(each.pin.tip), toVec2(foot), toU32(colors.rejected.withAlpha(alpha)),
                  line);
    const float round = 0.5F * head.size.y;
    list->AddRectFilled(toVec2(head.min - line), toVec2(head.max() + line), rim, round + line);
    list->AddRectFilled(toVec2(head.min), toVec2(head.max()),
                        toU32(colors.rejected.withAlpha(alpha)), round);
    if (each.hovered)
        list->AddRect(toVec2(head.min), toVec2(head.max()), toU32(colors.text), round, 0, line);
    if (each.pin.count == 1) return;
    const std::string text = std::to_string(each.pin.count);
    const float size = 0.9F * em;
    const ImVec2 extent = context.fonts.strong->CalcTextSizeA(size, 1e9F, 0.0F, text.c_str());
    const glm::vec2 middle = head.min + 0.5F * head.size;
    list->AddText(context.fonts.strong, size,
                  {std::round(middle.x - 0.5F * extent.x), std::round(middle.y - 0.5F * extent.y)},
                  toU32(alpha > kReadableFrom ? colors.background : colors.rejected), text.c_str());
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
        FaultPin each{pin, headOf(pin, textWidthOf(context, pin), context.rects.view, context.em)};
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
