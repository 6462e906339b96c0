// The lanes of the strip RUN: quantities of the run over all of its pivots.
#include "strips.h"

#include "paint/shapes.h"
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
void drawGathered(RunStrip& strip) {
    const LanePicture& picture = strip.picture();
    if (picture.gathered == 0) return;
    const float em = strip.context.em;
    const float bottom = strip.lanes.max().y;
    const float top = bottom - kGathered * em;
    strip.p.box({strip.lanes.min.x, top}, {strip.lanes.max().x, top + 1.0F},
                strip.p.ink(&Palette::border));
    const float unit = (bottom - top - 0.15F * em) / static_cast<float>(picture.gathered);
    const Ink ink = strip.p.ink(&Palette::used, 0.75F);
    for (std::size_t c = 0; c < picture.crowd.size(); ++c) {
        if (picture.crowd[c] == 0) continue;
        const float x = strip.bars.min.x + static_cast<float>(c);
        const float height = std::max(1.0F, unit * static_cast<float>(picture.crowd[c]));
        strip.p.box({x, bottom - height}, {x + 1.0F, bottom}, ink);
    }
}

/// The active ring thick, those that wait on the stack thin.
void drawBars(RunStrip& strip) {
    const float thick = std::max(2.0F, std::round(0.46F * strip.pitch));
    const float thin = std::max(1.0F, std::round(0.14F * strip.pitch));
    for (const bool active : {false, true}) {
        const Ink ink = strip.p.ink(&Palette::used, active ? 1.0F : 0.75F);
        for (const LaneBar& bar : strip.picture().bars) {
            if (bar.active != active) continue;
            const float y = std::round(strip.yOf(bar.row) - 0.5F * (active ? thick : thin));
            const float from = strip.bars.min.x + bar.from;
            const float to = std::max(strip.bars.min.x + bar.to, from + 1.0F);
            strip.p.box({from, y}, {to, y + (active ? thick : thin)}, ink);
        }
    }
}

void drawSign(RunStrip& strip, const LaneSign& sign) {
    const float em = strip.context.em;
    const float x = std::round(strip.bars.min.x + sign.x);
    const float y = strip.yOf(sign.row);
    const float size = std::clamp(0.75F * strip.pitch, 0.34F * em, 0.55F * em);
    const Ink ink = strip.p.ink(&Palette::text);
    switch (sign.kind) {
        case LaneChangeKind::Split:
        case LaneChangeKind::Join: {
            const float other = strip.yOf(sign.otherRow);
            strip.p.box({x, std::min(y, other)}, {x + strip.p.px(0.08F), std::max(y, other)},
                        strip.p.ink(&Palette::used));
            if (!sign.alone) break;
            // A split opens forward, a join closes: triangles on the lane that begins or ends.
            const bool split = sign.kind == LaneChangeKind::Split;
            drawShape(strip.p, {split ? x + 0.3F * size : x - 0.2F * size, y}, size,
                      split ? Shape::Forward : Shape::Back, ink);
            break;
        }
        case LaneChangeKind::Closed:
            strip.p.circle({x, y}, 0.5F * size, strip.p.ink(&Palette::background));
            drawShape(strip.p, {x, y}, size, Shape::Circle, ink);
            break;
        case LaneChangeKind::Freed:
        case LaneChangeKind::Failed:
            drawShape(strip.p, {x, y}, size, Shape::Square, ink);
            break;
        case LaneChangeKind::Hole:
            drawShape(strip.p, {x, y}, 1.15F * size, Shape::Cross, strip.p.ink(&Palette::rejected));
            break;
        case LaneChangeKind::Seed:
            strip.p.box({x, y - 0.5F * strip.pitch}, {x + strip.p.px(0.1F), y + 0.5F * strip.pitch},
                        ink);
            break;
        case LaneChangeKind::Activated:
            break;
    }
}

/// The letter of a ring where its lane begins, above the line; omitted in low rows.
void drawName(RunStrip& strip, const LaneSign& sign) {
    const Type type{0.75F * strip.context.em};
    if (!sign.alone || !beginsLane(sign.kind) || strip.pitch < 0.8F * type.size) return;
    const std::string name = ringName(sign.ring);
    const glm::vec2 extent = strip.p.textSize(name, type);
    const glm::vec2 at(strip.bars.min.x + sign.x + 0.7F * strip.context.em,
                       strip.yOf(sign.row) - 0.5F * extent.y);
    const glm::vec2 beside(0.15F * type.size, 0.0F);
    strip.p.box(at - beside, at + extent + beside, strip.p.ink(&Palette::background));
    strip.p.text(at, name, strip.p.ink(&Palette::text), type);
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

void drawRingLengths(RunStrip& strip) {
    const Ink ink = strip.p.ink(&Palette::used, 0.16F);
    const float bottom = strip.lanes.max().y;
    const auto& lengths = strip.picture().ringLength;
    for (std::size_t c = 0; c < lengths.size(); ++c) {
        if (lengths[c] <= 0.0F) continue;
        const float x = strip.bars.min.x + static_cast<float>(c);
        strip.p.box({x, bottom - lengths[c] * strip.lanes.size.y}, {x + 1.0F, bottom}, ink);
    }
}

void drawLanes(RunStrip& strip) {
    drawGathered(strip);
    drawBars(strip);
    for (const LaneSign& sign : strip.picture().signs) drawSign(strip, sign);
    for (const LaneSign& sign : strip.picture().signs) drawName(strip, sign);
}

void drawMore(RunStrip& strip) {
    const LanePicture& picture = strip.picture();
    if (picture.gathered == 0) return;
    const float em = strip.context.em;
    const Type type{0.85F * em};
    strip.p.text({strip.bars.min.x + 0.2F * em, strip.yOf(picture.rows - 1) - 0.5F * type.size},
                 "+" + grouped(picture.gathered), strip.p.ink(&Palette::textDim), type);
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
