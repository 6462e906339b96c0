/// The parts of the strip below the view, and the lanes within the strip of the run.
#pragma once

#include "panel_state/side_panels.h"
#include "panels/widgets/screen_painter.h"

namespace se::view {

/// The area of the bars of a strip: `top` below its upper edge, with a margin on both sides. Test
/// scripts find it as "strip run".
Rect beginStrip(const PanelContext& context, const char* name, const Rect& strip, float height,
                float top);
void drawTransport(const PanelContext& context, const Rect& area);
void drawRunStrip(const PanelContext& context, const Rect& area);
void drawPivotStrip(const PanelContext& context, const Rect& area);
void drawStageStrip(const PanelContext& context, const Rect& area);

struct RunStrip {
    const PanelContext& context;
    Rect bars;
    Rect lanes;  ///< Within bars, without the scale above.
    float pitch = 1.0F;
    ScreenPainter p{context};

    const LanePicture& picture() const { return context.state<Navigation>().lanes.picture; }
    const StripWindow& window() const { return context.state<Navigation>().strip; }
    float xOf(double pivot) const {
        return bars.min.x + static_cast<float>(window().shareOf(pivot)) * bars.size.x;
    }
    /// The middle of a row.
    float yOf(std::uint32_t row) const;
};

/// Rows for the lanes: if there are too many, the last one is shared.
std::uint32_t rowsFor(const RunStrip& strip);
/// Distance between rows as painted.
float pitchOf(const RunStrip& strip);
/// Length of the active ring, in the background.
void drawRingLengths(RunStrip& strip);
void drawLanes(RunStrip& strip);
/// Number of lanes without a row of their own, beside the shared row.
void drawMore(RunStrip& strip);
/// Tooltip of the shared row, if the mouse is there.
std::string gatheredText(const RunStrip& strip, ImVec2 mouse);

}  // namespace se::view
