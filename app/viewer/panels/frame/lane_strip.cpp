// The lanes of the strip RUN: quantities of the run over all of its pivots.
#include "strips.h"

#include "scene/draw_list.h"
#include "session/session.h"

#include <algorithm>
#include <cmath>

namespace se::view {

namespace {

/// Maximum height of a lane, in em; higher ones would look like a bar chart.
constexpr float kLeastLane = 0.5F;
constexpr float kHighestLane = 0.95F;
/// Height of the row that the remaining lanes share.
constexpr float kGathered = 1.0F;

/// The lanes without a row of their own: their number over time, as a skyline.
void drawGathered(const RunStrip& strip) {
    const LanePicture& picture = strip.picture();
    if (picture.gathered == 0) return;
    const float em = strip.context.em;
    const Palette& palette = strip.context.palette;
    const float bottom = strip.lanes.max().y;
    const float top = bottom - kGathered * em;
    strip.list->AddRectFilled({strip.lanes.min.x, top}, {strip.lanes.max().x, top + 1.0F},
                              toU32(palette.border));
    const float unit = (bottom - top - 0.15F * em) / static_cast<float>(picture.gathered);
    const ImU32 color = toU32(palette.used.withAlpha(0.75F));
    for (std::size_t c = 0; c < picture.crowd.size(); ++c) {
        if (picture.crowd[c] == 0) continue;
        const float x = strip.bars.min.x + static_cast<float>(c);
        const float height = std::max(1.0F, unit * static_cast<float>(picture.crowd[c]));
        strip.list->AddRectFilled({x, bottom - height}, {x + 1.0F, bottom}, color);
    }
}

/// The active ring thick, those that wait on the stack thin.
void drawBars(const RunStrip& strip) {
    const Palette& palette = strip.context.palette;
    const float thick = std::max(2.0F, std::round(0.46F * strip.pitch));
    const float thin = std::max(1.0F, std::round(0.14F * strip.pitch));
    for (const bool active : {false, true}) {
        const ImU32 color = toU32(palette.used.withAlpha(active ? 1.0F : 0.75F));
        for (const LaneBar& bar : strip.picture().bars) {
            if (bar.active != active) continue;
            const float y = std::round(strip.yOf(bar.row) - 0.5F * (active ? thick : thin));
            const float from = strip.bars.min.x + bar.from;
            const float to = std::max(strip.bars.min.x + bar.to, from + 1.0F);
            strip.list->AddRectFilled({from, y}, {to, y + (active ? thick : thin)}, color);
        }
    }
}

void drawSign(const RunStrip& strip, const LaneSign& sign) {
    const Palette& palette = strip.context.palette;
    const float em = strip.context.em;
    const float x = std::round(strip.bars.min.x + sign.x);
    const float y = strip.yOf(sign.row);
    const float size = std::clamp(0.75F * strip.pitch, 0.34F * em, 0.55F * em);
    const ImU32 color = toU32(palette.text);
    switch (sign.kind) {
        case LaneChangeKind::Split:
        case LaneChangeKind::Join: {
            const ImU32 line = toU32(palette.used);
            strip.list->AddRectFilled(
                {x, std::min(y, strip.yOf(sign.otherRow))},
                {x + std::max(1.0F, 0.08F * em), std::max(y, strip.yOf(sign.otherRow))}, line);
            if (!sign.alone) break;
            // A split opens forward, a join closes: triangles on the lane that begins or ends.
            const bool split = sign.kind == LaneChangeKind::Split;
            drawShape(strip.list, {split ? x + 0.3F * size : x - 0.2F * size, y}, size,
                      split ? Shape::Forward : Shape::Back, color);
            break;
        }
        case LaneChangeKind::Closed:
            strip.list->AddCircleFilled({x, y}, 0.5F * size, toU32(palette.background));
            drawShape(strip.list, {x, y}, size, Shape::Circle, color);
            break;
        case LaneChangeKind::Freed:
        case LaneChangeKind::Failed:
            drawShape(strip.list, {x, y}, size, Shape::Square, color);
            break;
        case LaneChangeKind::Hole:
            drawShape(strip.list, {x, y}, 1.15F * size, Shape::Cross, toU32(palette.rejected));
            break;
        case LaneChangeKind::Seed:
            strip.list->AddRectFilled({x, y - 0.5F * strip.pitch},
                                      {x + std::max(1.0F, 0.1F * em), y + 0.5F * strip.pitch},
                                      color);
            break;
        case LaneChangeKind::Activated:
            break;
    }
}

/// The letter of a ring where its lane begins, above the line; omitted in low rows.
void drawName(const RunStrip& strip, const LaneSign& sign) {
    const float size = 0.75F * strip.context.em;
    if (!sign.alone || !beginsLane(sign.kind) || strip.pitch < 0.8F * size) return;
    const Palette& palette = strip.context.palette;
    const std::string name = ringName(sign.ring);
    const ImVec2 extent = strip.context.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, name.c_str());
    const ImVec2 at(strip.bars.min.x + sign.x + 0.7F * strip.context.em,
                    strip.yOf(sign.row) - 0.5F * extent.y);
    fill(strip.list, {{at.x - 0.15F * size, at.y}, {extent.x + 0.3F * size, extent.y}},
         palette.background);
    strip.list->AddText(strip.context.fonts.text, size, at, toU32(palette.text), name.c_str());
}

}  // namespace

float RunStrip::yOf(std::uint32_t row) const {
    if (picture().gathered > 0 && row + 1 == picture().rows)
        return lanes.max().y - 0.5F * kGathered * context.em;
    return lanes.min.y + (static_cast<float>(row) + 0.5F) * pitch;
}

std::uint32_t rowsFor(const RunStrip& strip) {
    const float em = strip.context.em;
    const std::uint32_t lanes = strip.context.session().overview().lanes;
    const auto fit = [em](float room) {
        return static_cast<std::uint32_t>(std::max(0.0F, room / (kLeastLane * em)));
    };
    if (lanes <= fit(strip.lanes.size.y)) return std::max(1U, lanes);
    return fit(strip.lanes.size.y - kGathered * em) + 1;
}

float pitchOf(const RunStrip& strip) {
    const float em = strip.context.em;
    const bool shared = strip.picture().gathered > 0;
    const float room = strip.lanes.size.y - (shared ? kGathered * em : 0.0F);
    const std::uint32_t own = strip.picture().rows - (shared ? 1U : 0U);
    return std::min(kHighestLane * em, room / static_cast<float>(std::max(1U, own)));
}

void drawRingLengths(const RunStrip& strip) {
    const ImU32 color = toU32(strip.context.palette.used.withAlpha(0.16F));
    const float bottom = strip.lanes.max().y;
    const auto& lengths = strip.picture().ringLength;
    for (std::size_t c = 0; c < lengths.size(); ++c) {
        if (lengths[c] <= 0.0F) continue;
        const float x = strip.bars.min.x + static_cast<float>(c);
        strip.list->AddRectFilled({x, bottom - lengths[c] * strip.lanes.size.y}, {x + 1.0F, bottom},
                                  color);
    }
}

void drawLanes(const RunStrip& strip) {
    drawGathered(strip);
    drawBars(strip);
    for (const LaneSign& sign : strip.picture().signs) drawSign(strip, sign);
    for (const LaneSign& sign : strip.picture().signs) drawName(strip, sign);
}

void drawMore(const RunStrip& strip) {
    const LanePicture& picture = strip.picture();
    if (picture.gathered == 0) return;
    const float em = strip.context.em;
    const float size = 0.85F * em;
    const std::string text = "+" + grouped(picture.gathered);
    ImFont* font = strip.context.fonts.text;
    const float y = strip.yOf(picture.rows - 1) - 0.5F * size;
    strip.list->AddText(font, size, {strip.bars.min.x + 0.2F * em, y},
                        toU32(strip.context.palette.textDim), text.c_str());
}

std::string gatheredText(const RunStrip& strip, ImVec2 mouse) {
    const LanePicture& picture = strip.picture();
    const float top = strip.lanes.max().y - kGathered * strip.context.em;
    if (picture.gathered == 0 || mouse.y < top) return {};
    const float place = std::max(0.0F, mouse.x - strip.bars.min.x);
    const std::size_t column = std::min(static_cast<std::size_t>(place), picture.crowd.size() - 1);
    return "\n" + grouped(picture.crowd[column]) + " of the " + grouped(picture.gathered) +
           " lanes that share this row";
}

}  // namespace se::view
