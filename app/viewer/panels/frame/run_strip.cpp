// The strip of the run: all of it over its pivots, with all that was noticed, marked or compared on
// it. The lanes of the rings are kept as a picture of one column per pixel, and are made again only
// when the run, the window of the strip or its room has changed.
#include <algorithm>
#include <cmath>

#include "compare/comparison.h"
#include "input/view_drag.h"
#include "jobs/kept_pass.h"
#include "paint/shapes.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/screen_painter.h"
#include "session/playback.h"
#include "session/session.h"
#include "session/session_file.h"
#include "spiraling_edge/run/breakpoint.h"
#include "view_parts.h"

namespace se::view {

// The lanes of the strip RUN: quantities of the run over all of its pivots.

namespace {

/// Least and greatest height of a lane, in em; higher ones would look like a bar chart.
constexpr float kLeastLane = 0.4F;
constexpr float kHighestLane = 0.95F;
/// Size of the name of a ring, in em: the least that can be read, and the greatest.
constexpr float kLeastRingName = 0.6F;
constexpr float kLargestRingName = 0.75F;
/// Height of the row that the remaining lanes share.
constexpr float kGathered = 1.0F;

/// The inputs of a painting of the lanes.
struct LaneInputs {
    std::uint32_t generation = 0;
    std::size_t pivots = 0;
    std::size_t changes = 0;
    bool complete = false;
    StripWindow window;
    LaneRoom room;
    friend bool operator==(const LaneInputs&, const LaneInputs&) = default;
};

/// The lanes as last painted.
struct PaintedLanes {
    LaneInputs inputs;
    LanePicture picture;
    CursorWatch watch;  ///< Moves of the cursor, which the strip follows.
};

struct RunStrip {
    const PanelContext& context;
    Rect bars;
    Rect lanes;  ///< Within bars, without the scale above.
    float pitch = 1.0F;
    ScreenPainter p{context};

    const LanePicture& picture() const { return context.state<PaintedLanes>().picture; }
    const StripWindow& window() const { return context.state<Navigation>().strip; }
    float xOf(double pivot) const {
        return bars.min.x + static_cast<float>(window().shareOf(pivot)) * bars.size.x;
    }
    /// The middle of a row.
    float yOf(std::uint32_t row) const {
        if (picture().gathered > 0 && row + 1 == picture().rows)
            return lanes.max().y - 0.5F * kGathered * context.em;
        return lanes.min.y + (static_cast<float>(row) + 0.5F) * pitch;
    }
};

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

/// The letter of a ring where its lane begins, as high as its row; omitted in lower rows.
void drawName(RunStrip& strip, const LaneSign& sign) {
    const float em = strip.context.em;
    const Type type{std::min(kLargestRingName * em, strip.pitch / 0.8F)};
    if (!sign.alone || !beginsLane(sign.kind) || type.size < kLeastRingName * em) return;
    const std::string name = ringName(sign.ring);
    const glm::vec2 extent = strip.p.textSize(name, type);
    const glm::vec2 middle(strip.bars.min.x + sign.x + 0.7F * em + 0.5F * extent.x,
                           strip.yOf(sign.row));
    // The lanes beside it stay whole.
    const glm::vec2 half(0.5F * extent.x + 0.15F * type.size,
                         0.5F * std::min(extent.y, 0.9F * strip.pitch));
    strip.p.box(middle - half, middle + half, strip.p.ink(&Palette::background));
    strip.p.text(middle - 0.5F * extent, name, strip.p.ink(&Palette::text), type);
    strip.context.where()["lane " + name] = {middle - half, 2.0F * half};
}

/// Rows for the lanes: if there are too many, the last one is shared.
std::uint32_t rowsFor(const RunStrip& strip) {
    const float em = strip.context.em;
    const std::uint32_t lanes = strip.context.session().overview().lanes;
    const auto fit = [em](float room) {
        return static_cast<std::uint32_t>(std::max(0.0F, room / (kLeastLane * em)));
    };
    if (lanes <= fit(strip.lanes.size.y)) return std::max(1U, lanes);
    return fit(strip.lanes.size.y - kGathered * em) + 1;
}

/// Distance between rows as painted.
float pitchOf(const RunStrip& strip) {
    const float em = strip.context.em;
    const bool shared = strip.picture().gathered > 0;
    const float room = strip.lanes.size.y - (shared ? kGathered * em : 0.0F);
    const std::uint32_t own = strip.picture().rows - (shared ? 1U : 0U);
    return std::min(kHighestLane * em, room / static_cast<float>(std::max(1U, own)));
}

/// Length of the active ring, in the background.
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

/// Number of lanes without a row of their own, beside the shared row.
void drawMore(RunStrip& strip) {
    const LanePicture& picture = strip.picture();
    if (picture.gathered == 0) return;
    const float em = strip.context.em;
    const Type type{0.85F * em};
    strip.p.text({strip.bars.min.x + 0.2F * em, strip.yOf(picture.rows - 1) - 0.5F * type.size},
                 "+" + grouped(picture.gathered), strip.p.ink(&Palette::textDim), type);
}

/// Tooltip of the shared row, if the mouse is there.
std::string gatheredText(const RunStrip& strip, ImVec2 mouse) {
    const LanePicture& picture = strip.picture();
    const float top = strip.lanes.max().y - kGathered * strip.context.em;
    if (picture.gathered == 0 || mouse.y < top) return {};
    const float place = std::max(0.0F, mouse.x - strip.bars.min.x);
    const std::size_t column = std::min(static_cast<std::size_t>(place), picture.crowd.size() - 1);
    return "\n" + grouped(picture.crowd[column]) + " of the " + grouped(picture.gathered) +
           " lanes that share this row";
}

/// Repaints the lanes if the run, the window or their room has changed.
void keepPainted(const PanelContext& context, const LaneRoom& room) {
    const Session& session = context.session();
    const RunOverview& run = session.overview();
    PaintedLanes& lanes = context.state<PaintedLanes>();
    const StripWindow& window = context.state<Navigation>().strip;
    const LaneInputs now{session.generation(),
                         run.pivots.size(),
                         run.laneChanges.size(),
                         run.complete,
                         window,
                         room};
    if (std::exchange(lanes.inputs, now) == now) return;
    lanes.picture = makeLanePicture(run, window, room);
}

/// Pivots along the top, at round numbers.
void drawScale(RunStrip& strip) {
    const float em = strip.context.em;
    const double room =
        6.0 * em / strip.bars.size.x * (strip.window().to() - strip.window().from());
    double step = std::pow(10.0, std::ceil(std::log10(std::max(1.0, room))));
    if (step / 5.0 >= room) {
        step /= 5.0;
    } else if (step / 2.0 >= room) {
        step /= 2.0;
    }
    step = std::max(1.0, step);
    const Type type{0.78F * em};
    for (double pivot = std::ceil(strip.window().from() / step) * step;
         pivot <= strip.window().to(); pivot += step) {
        const float x = std::round(strip.xOf(pivot));
        const std::string text = grouped(static_cast<std::size_t>(pivot));
        const float width = strip.p.textSize(text, type).x;
        strip.p.box({x, strip.lanes.min.y}, {x + 1.0F, strip.lanes.max().y},
                    strip.p.ink(&Palette::textDim, 0.22F));
        const float left =
            std::clamp(x - 0.5F * width, strip.bars.min.x, strip.bars.max().x - width);
        strip.p.text({left, strip.bars.min.y}, text, strip.p.ink(&Palette::textDim), type);
    }
}

void drawAlertMarks(RunStrip& strip) {
    const float em = strip.context.em;
    const float y = strip.lanes.min.y;
    for (const LaneAlert& alert : strip.picture().alerts) {
        const float x = strip.bars.min.x + alert.x;
        strip.p.polygon(
            {{x - 0.3F * em, y - 0.25F * em}, {x + 0.3F * em, y - 0.25F * em}, {x, y + 0.25F * em}},
            strip.p.ink(&Palette::rejected));
    }
}

/// Failures on the way: thin strokes along the top of the lanes, one per pixel; and the
/// three moments of the chosen alert.
void drawNoticed(RunStrip& strip) {
    const Session& session = strip.context.session();
    const float em = strip.context.em;
    const float top = strip.lanes.min.y;
    const float bottom = strip.lanes.max().y;
    float last = -1.0F;
    for (const LiveFailure& each : session.overview().failures) {
        const float x = std::round(strip.xOf(each.address.pivot));
        if (x == last || x < strip.bars.min.x || x > strip.bars.max().x) continue;
        last = x;
        strip.p.box({x, top - 0.1F * em}, {x + 1.0F, top + 0.3F * em},
                    strip.p.ink(&Palette::rejected));
    }
    const RunFailure* alert = session.alerts().shown();
    if (alert == nullptr) return;
    const FailureMoments& moments = alert->moments;
    for (const LedgerLine* line : {&moments.created, &moments.decided, &moments.touched}) {
        const float x = std::round(strip.xOf(line->event.address.pivot));
        if (x < strip.bars.min.x || x > strip.bars.max().x) continue;
        const bool created = line == &moments.created;
        const Ink ink = strip.p.ink(created ? &Palette::rejected : &Palette::text);
        strip.p.box({x - 0.04F * em, top}, {x + 0.04F * em + 1.0F, bottom}, ink.withAlpha(0.8F));
        strip.p.circle({x + 0.5F, bottom - 0.3F * em}, 0.28F * em, ink);
    }
}

/// A flag with the number of the bookmark, while there is a key for it.
void drawBookmarkMarks(RunStrip& strip) {
    const float em = strip.context.em;
    const Ink ink = strip.p.ink(&Palette::text);
    const Bookmarks& marks = strip.context.state<Bookmarks>();
    const float bottom = strip.lanes.max().y;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const float x = std::round(strip.xOf(marks[i].address.pivot));
        if (x < strip.bars.min.x || x > strip.bars.max().x) continue;
        strip.p.box({x, strip.lanes.min.y}, {x + 1.0F, bottom}, ink.withAlpha(0.45F));
        strip.p.polygon({{x, bottom - 0.8F * em},
                         {x + 0.6F * em, bottom - 0.55F * em},
                         {x, bottom - 0.3F * em}},
                        ink);
        if (i < kBookmarkKeys)
            strip.p.text({x + 0.65F * em, bottom - 0.95F * em},
                         std::to_string((i + 1) % kBookmarkKeys), ink, {0.75F * em});
    }
}

/// A tick at each pivot where the run stops: upright, from the lower edge of the lanes.
void drawStops(RunStrip& strip) {
    const PanelContext& context = strip.context;
    const float bottom = strip.lanes.max().y;
    const float top = bottom - 0.45F * context.em;
    const auto columns = static_cast<std::size_t>(std::max(1.0F, strip.bars.size.x));
    const float width = std::max(2.0F, 0.12F * context.em);
    for (const Breakpoint& each : context.session().hits().wanted()) {
        const LineHits* known = context.session().hits().of(each.line);
        if (!each.on || known == nullptr) continue;
        const Ink ink = strip.p.ink(each.logOnly ? &Palette::textDim : &Palette::test);
        for (const std::uint32_t pivot :
             stopPivots(each, known->list, {strip.window().from(), strip.window().to()}, columns)) {
            const float x = std::round(strip.xOf(pivot));
            strip.p.box({x - 0.5F * width, top}, {x + 0.5F * width, bottom}, ink);
        }
    }
}

/// X of the pivot where the two compared runs diverge; -1 if there is none.
float xOfDifference(const RunStrip& strip) {
    const Compared* found = strip.context.state<ComparePage>().result();
    if (found == nullptr || !found->runs.first || !found->runs.first->a.line) return -1.0F;
    return std::round(strip.xOf(found->runs.first->a.line->event.address.pivot));
}

/// The diamond drawn there; empty if there is none.
Rect differenceMark(const RunStrip& strip) {
    const float x = xOfDifference(strip);
    if (x < strip.bars.min.x || x > strip.bars.max().x) return {};
    const float half = 0.4F * strip.context.em;
    return {{x + 0.5F - half, strip.lanes.max().y - 2.0F * half}, glm::vec2(2.0F * half)};
}

void drawDifference(RunStrip& strip) {
    const Rect mark = differenceMark(strip);
    if (mark.size.x <= 0.0F) return;
    const glm::vec2 at = mark.min + 0.5F * mark.size;
    const glm::vec2 top(at.x, mark.min.y);
    const glm::vec2 bottom(at.x, mark.max().y);
    const glm::vec2 left(mark.min.x, at.y);
    const glm::vec2 right(mark.max().x, at.y);
    strip.p.box({at.x - 0.5F, strip.lanes.min.y}, {at.x + 0.5F, mark.min.y},
                strip.p.ink(&Palette::text, 0.6F));
    strip.p.polygon({left, top, bottom}, strip.p.ink(&Palette::used));
    strip.p.polygon({top, right, bottom}, strip.p.ink(&Palette::last));
    strip.p.polygon({left, top, right, bottom}, strip.p.ink(&Palette::background).line(1.0F));
    strip.context.where()["strip difference"] = mark;
}

/// Tooltip of the first difference, if the mouse is there.
std::string differenceText(const RunStrip& strip, ImVec2 mouse) {
    const float x = xOfDifference(strip);
    if (x < 0.0F || std::abs(mouse.x - x) > 0.5F * strip.context.em) return {};
    const RunDifference& first = *strip.context.state<ComparePage>().result()->runs.first;
    const auto at = [](const DifferenceSide& side) {
        return side.line ? toString(side.line->event.address) : std::string("the run has ended");
    };
    return "\nfirst difference: A " + at(first.a) + ", B " + at(first.b) + "\n" + first.words;
}

/// The stretch of the playback loop; a mark alone is a bracket.
void drawLoop(RunStrip& strip) {
    const PlayLoop& loop = strip.context.playback().loop;
    if (loop.empty()) return;
    const float em = strip.context.em;
    const Ink ink = strip.p.ink(&Palette::pivot);
    const float top = strip.lanes.min.y;
    const float bottom = strip.lanes.max().y;
    if (loop.complete())
        strip.p.box({strip.xOf(loop.from->pivot), top}, {strip.xOf(loop.to->pivot), bottom},
                    ink.withAlpha(0.1F));
    const auto bracket = [&](const Address& at, float side, const char* letter) {
        const float x = strip.xOf(at.pivot);
        const float width = 0.14F * em;
        strip.p.box({x - 0.5F * width, top}, {x + 0.5F * width, bottom}, ink);
        for (const float y : {top, bottom - width})
            strip.p.box({std::min(x, x + side * 0.4F * em), y},
                        {std::max(x, x + side * 0.4F * em), y + width}, ink);
        strip.p.text({x + side * 0.55F * em, bottom - 1.2F * em}, letter, ink,
                     {0.8F * em, Typeface::Text, side < 0.0F ? Align::Right : Align::Left});
    };
    if (loop.from) bracket(*loop.from, 1.0F, "A");
    if (loop.to) bracket(*loop.to, -1.0F, "B");
}

void drawPlayhead(RunStrip& strip) {
    const Session& session = strip.context.session();
    const float at = strip.xOf(std::min<double>(session.record().pivot, strip.window().last()));
    if (at < strip.bars.min.x - 1.0F || at > strip.bars.max().x + 1.0F) return;
    const float x = std::round(at);
    const float em = strip.context.em;
    const float top = strip.bars.min.y;
    const Ink ink = strip.p.ink(&Palette::pivot);
    strip.p.box({x - 0.06F * em, top}, {x + 0.06F * em + 1.0F, strip.bars.max().y}, ink);
    strip.p.polygon({{x - 0.38F * em, top - 0.2F * em},
                     {x + 0.38F * em, top - 0.2F * em},
                     {x, top + 0.4F * em}},
                    ink);
}

std::string tooltipText(const RunStrip& strip, std::uint32_t pivot, ImVec2 mouse) {
    const RunOverview& run = strip.context.session().overview();
    std::string text = "pivot " + grouped(pivot);
    if (pivot > 0 && pivot <= run.ringLength.size()) {
        text += "\nring of " + grouped(run.ringLength[pivot - 1]) + ", " +
                grouped(run.stackDepth[pivot - 1]) + " stacked\n" +
                grouped(run.triangles[pivot - 1]) + " triangles";
    }
    text += differenceText(strip, mouse);
    text += gatheredText(strip, mouse);
    // The triangle of an alert is above the lanes, and is as wide as this.
    const LaneAlert* alert =
        alertNear(strip.picture(), mouse.x - strip.bars.min.x, 0.6F * strip.context.em);
    if (alert != nullptr) text += "\n" + alertText(*alert);
    // Meaning of the mark under the pointer.
    const LaneSign* nearest = nullptr;
    float best = 0.7F * strip.context.em;
    for (const LaneSign& sign : strip.picture().signs) {
        const float dx = strip.bars.min.x + sign.x - mouse.x;
        const float distance = std::hypot(dx, strip.yOf(sign.row) - mouse.y);
        if (distance < best) best = distance, nearest = &sign;
    }
    if (nearest == nullptr) return text;
    return text + "\nring " + laneChangeText(nearest->kind) + " at pivot " +
           grouped(nearest->pivot);
}

void handleMouse(const RunStrip& strip) {
    Session& session = strip.context.session();
    StripWindow& window = strip.context.state<Navigation>().strip;
    ImGui::SetCursorScreenPos(toVec2(strip.bars.min));
    ImGui::InvisibleButton("##run", toVec2(strip.bars.size),
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const ImGuiIO& io = ImGui::GetIO();
    const double share =
        std::clamp((io.MousePos.x - strip.bars.min.x) / strip.bars.size.x, 0.0F, 1.0F);
    const auto pivot = static_cast<std::uint32_t>(std::llround(window.pivotAt(share)));
    const bool moved = io.MouseDelta.x != 0.0F;
    ViewDrag& drag = strip.context.state<ViewDrag>();
    if (ImGui::IsItemActivated()) drag.begin();
    const bool onMark = differenceMark(strip).contains({io.MousePos.x, io.MousePos.y});
    if (ImGui::IsItemActivated() && onMark && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        // Each to its own address, like its key.
        strip.context.playback().pause();
        strip.context.run("step.difference");
    } else if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
        const float by = drag.move({io.MousePos.x, io.MousePos.y}, 0.0F).x;
        if (by != 0.0F) window.pan(-by / strip.bars.size.x);
    } else if (ImGui::IsItemActive() && session.record().pivot != pivot &&
               (ImGui::IsItemActivated() || moved)) {
        strip.context.pausedMoves().goToPivot(pivot);
    }
    if (!ImGui::IsItemHovered()) return;
    if (io.MouseWheel != 0.0F) window.zoomAt(share, io.MouseWheel);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) window.showAll();
    tooltip(tooltipText(strip, pivot, io.MousePos));
}

/// Keeps the strip's window on the run, and on the cursor when it moves.
void keepWindow(const PanelContext& context) {
    const Session& session = context.session();
    PaintedLanes& lanes = context.state<PaintedLanes>();
    StripWindow& window = context.state<Navigation>().strip;
    if (lanes.inputs.generation != session.generation()) window.showAll();
    window.setLast(std::max({1U, session.overview().lastPivot, session.record().pivot}));
    const bool moved =
        lanes.watch.moved(session.generation(), session.record().pivot, session.cursor());
    if (moved && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) window.reveal(session.record().pivot);
}

}  // namespace

void drawRunStrip(const PanelContext& context, const Rect& area) {
    const Session& session = context.session();
    const float em = context.em;
    const bool folded = context.rects.stripFolded;
    const float top = 0.55F * em;
    const Rect bars =
        beginStrip(context, "run", area, area.size.y - top - (folded ? 0.5F : 0.3F) * em, top);
    if (!session.ready()) return;
    keepWindow(context);
    // Folded, the scale is drawn only where it covers nothing.
    const float scale = folded ? 0.35F * em : 1.0F * em;
    RunStrip strip{context, bars, {{bars.min.x, bars.min.y + scale}, bars.size}};
    strip.lanes.size.y = bars.size.y - scale;
    keepPainted(context, {bars.size.x, rowsFor(strip), 0.7F * em});
    strip.pitch = pitchOf(strip);
    strip.p.box(strip.lanes, strip.p.ink(&Palette::background), 0.2F * em);
    ImGui::PushClipRect({bars.min.x - 0.4F * em, area.min.y},
                        {bars.max().x + 0.4F * em, area.max().y}, true);
    drawRingLengths(strip);
    if (!folded) drawScale(strip);
    drawLanes(strip);
    drawAlertMarks(strip);
    drawNoticed(strip);
    drawLoop(strip);
    drawStops(strip);
    drawBookmarkMarks(strip);
    drawPlayhead(strip);
    drawDifference(strip);
    ImGui::PopClipRect();
    if (!folded) drawMore(strip);
    handleMouse(strip);
}

}  // namespace se::view
