/// The dial on the screen: one disc of a tangent plane, and the smaller one of a ring point.
#pragma once

#include <imgui.h>

#include <cmath>
#include <vector>

#include "layout/dial.h"
#include "layout/overlays.h"
#include "panels/panel.h"
#include "rows/dial.h"

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
/// Draws texts around the rim, none over another; the first in the list are closest to their
/// points. `taken`: areas without texts.
void drawRimTexts(const PanelContext& context, const DialDisc& disc, const Rect& room,
                  std::span<const Rect> taken, std::span<const RimText> texts);
/// Size of such a text.
glm::vec2 rimTextSize(const PanelContext& context, const std::string& text);
/// The largest disc in `room` that leaves room for the texts.
DialDisc discWithTexts(const PanelContext& context, const Rect& room,
                       std::span<const RimText> texts);

/// A sector, in parts of at most half a turn: only those are convex.
void fillSector(const DialDisc& disc, double from, double to, float reach, const Color& color);

/// The dial of the pivot.
class DialDrawer {
  public:
    DialDrawer(const PanelContext& context, const Dial& dial, const DialDisc& disc);

    /// Draws nothing outside of `room`. `taken`: the part of it that is used already.
    void draw(const Rect& room, std::span<const Rect> taken);
    /// The tick nearest to the pointer, null if none is near.
    const DialTick* underPointer() const;

  private:
    float px(float width = 0.08F) const { return std::max(1.0F, width * c_.em); }
    ImVec2 tip(const DialTick& tick) const {
        return disc_.at(tick.degrees, 0.92F * std::max(0.12F, tick.reach));
    }
    void strokeArc(double from, double to, float reach, const Color& color, float width,
                   bool dashed);
    void drawArc(const DialArc& arc);
    void drawChord(const DialChord& chord);
    void drawMark(const DialMark& mark);
    void drawSlot(const DialSlot& slot);
    void drawRefusal(const DialTick& tick, ImU32 color);
    void drawStem(const DialTick& tick, const Color& color);
    void drawTick(const DialTick& tick);
    void drawRings(const DialTick& tick);
    std::vector<RimText> texts() const;
    Color colorOf(const DialTick& tick) const;
    void drawRank(const DialTick& tick);

    const PanelContext& c_;
    const Dial& dial_;
    DialDisc disc_;
    ImDrawList* list_;
    Rect room_;
    std::vector<ImVec2> ranks_;  ///< Names so far.
};

/// The second disc (Fig. 6): the pivot as seen from e, with the names of the ends of the sector of
/// e.
void drawReciprocalDial(const PanelContext& context, const DialReciprocal& reciprocal,
                        const Rect& room);

}  // namespace se::view
