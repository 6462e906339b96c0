/// The dial on the screen: one disc of a tangent plane, and the smaller one of a ring point.
#pragma once

#include <imgui.h>

#include <cmath>

#include "layout/dial.h"
#include "layout/overlays.h"
#include "panels/panel.h"
#include "rows/pivot_dial.h"

namespace se::view {

inline constexpr float kDialDegree = 3.14159265F / 180.0F;

/// The disc on the screen: angle 0 to the right, counterclockwise.
struct DialDisc {
    ImVec2 center;
    float radius = 0.0F;

    ImVec2 at(double degrees, float reach) const {
        const float a = static_cast<float>(degrees) * kDialDegree;
        return {center.x + reach * radius * std::cos(a), center.y - reach * radius * std::sin(a)};
    }
};

/// Text at the rim.
struct RimText {
    double degrees = 0.0;
    std::string text;
    Color color;
};
/// The largest disc in `room` that leaves room for the texts.
DialDisc discWithTexts(const PanelContext& context, const Rect& room,
                       std::span<const RimText> texts);

/// Draws the dial of the pivot, nothing outside of `room`. `taken`: the part of it that is used
/// already.
void drawDialDisc(const PanelContext& context, const Dial& dial, const DialDisc& disc,
                  const Rect& room, std::span<const Rect> taken);
/// The tick nearest to the pointer, null if none is near.
const DialTick* tickUnderPointer(const PanelContext& context, const Dial& dial,
                                 const DialDisc& disc);
/// The second disc (Fig. 6): the pivot as seen from e, with the names of the ends of the sector of
/// e.
void drawReciprocalDial(const PanelContext& context, const DialReciprocal& reciprocal,
                        const Rect& room);

}  // namespace se::view
