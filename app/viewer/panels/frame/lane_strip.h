/// The lanes within the strip RUN.
#pragma once

#include "panels/panel.h"
#include "panels/widgets/widgets.h"

namespace se::view {

struct RunStrip {
    const PanelContext& context;
    Rect bars;
    Rect lanes;  ///< Within bars, without the scale above.
    float pitch = 1.0F;

    const LanePicture& picture() const { return context.ui().navigation.lanes.picture; }
    const StripWindow& window() const { return context.ui().navigation.strip; }
    float xOf(double pivot) const {
        return bars.min.x + static_cast<float>(window().shareOf(pivot)) * bars.size.x;
    }
    /// The middle of a row.
    float yOf(std::uint32_t row) const;
};

/// Rows for the lanes: if there are too many, the last one is that which they share.
std::uint32_t rowsFor(const RunStrip& strip);
/// From one row to the next, of what is painted.
float pitchOf(const RunStrip& strip);
/// How long the active ring is, behind everything.
void drawRingLengths(const RunStrip& strip);
void drawLanes(const RunStrip& strip);
/// How many lanes have no row of their own, beside the row that they share.
void drawMore(const RunStrip& strip);
/// A line about the row that lanes share, if the mouse is there.
std::string gatheredText(const RunStrip& strip, ImVec2 mouse);

}  // namespace se::view
