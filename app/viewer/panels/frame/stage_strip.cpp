// The strips PIVOT, the stages of the pivot at the cursor, and STAGE, the events of one of them.
#include <algorithm>

#include "paint/shapes.h"
#include "panel_state/side_panels.h"
#include "run/number_format.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"
#include "strips.h"

namespace se::view {

namespace {

/// Narrower cells are not drawn one by one.
constexpr float kLeastTick = 2.0F;
/// Width of a cell of the STAGE strip, in em: the least, and from which it has a sentence.
constexpr float kLeastCell = 2.4F;
constexpr float kSentenceFrom = 14.0F;
/// Size of the name of a stage, in em.
constexpr float kStageName = 0.85F;

Color cellColor(const PanelContext& context, const Event& event) {
    if (event.address.stage == Stage::Emit) return context.palette.test;
    return outcomeColor(context.palette, event).value_or(context.palette.textDim);
}

void frameHere(const PanelContext& context, const Rect& cell) {
    ScreenPainter painter(context);
    painter.box(cell.min - 1.0F, cell.max() + 1.0F,
                painter.ink(&Palette::pivot).line(std::max(1.5F, 0.13F * context.em)),
                0.2F * context.em);
}

/// Instead of cells, at the start of the run.
void drawNone(const PanelContext& context, const Rect& bars, const char* text) {
    const float y = bars.min.y + 0.5F * (bars.size.y - context.em);
    ImGui::GetWindowDrawList()->AddText({bars.min.x, y}, toU32(context.palette.textDim), text);
}

/// An item over a picture: a click goes to the event.
void offerEvent(const PanelContext& context, const char* id, const Rect& area, std::size_t event) {
    ImGui::SetCursorScreenPos(toVec2(area.min));
    ImGui::PushID(static_cast<int>(event));
    if (ImGui::InvisibleButton(id, toVec2(area.size))) {
        context.playback().pause();
        context.session().moves().goToEvent(event);
    }
    ImGui::PopID();
}

// ---- PIVOT: one block per stage ---------------------------------------------------------------

/// A stage is as wide as its tests, but at least as wide as its name.
std::vector<float> widthsOf(const PanelContext& context, const std::vector<StageRun>& runs,
                            float total, float gap) {
    std::vector<float> widths;
    float sum = 0.0F;
    for (const StageRun& run : runs) {
        const float text =
            ScreenPainter(context)
                .textSize(std::string(stageName(run.stage)), {kStageName * context.em})
                .x;
        const float cells = static_cast<float>(run.size()) * 1.15F * context.em;
        widths.push_back(std::max(text + 0.2F * gap, std::min(cells, 0.5F * total)));
        sum += widths.back();
    }
    const float room = total - gap * static_cast<float>(runs.size());
    const float factor = std::min(1.0F, room / std::max(1.0F, sum));
    for (float& width : widths) width *= factor;
    return widths;
}

/// The events of a stage, one tick each; as one piece if there are too many.
void drawTicks(const PanelContext& context, const StageRun& run, const Rect& block) {
    const Session& session = context.session();
    ScreenPainter painter(context);
    const float width = block.size.x / static_cast<float>(run.size());
    if (width < kLeastTick) {
        const float alpha = run.begin > session.cursor() ? 0.3F : 0.7F;
        return painter.box(
            block, painter.ink(run.refused > 0 ? &Palette::rejected : &Palette::textDim, alpha),
            0.15F * context.em);
    }
    for (std::size_t e = run.begin; e < run.end; ++e) {
        const Event& event = session.record().events[e];
        const bool later = e > session.cursor();
        const float x = block.min.x + width * static_cast<float>(e - run.begin);
        const float inset = width > 4.0F ? 1.0F : 0.0F;
        painter.box({x + inset, block.min.y}, {x + width - inset, block.max().y},
                    Ink(cellColor(context, event)).withAlpha(later ? 0.3F : 0.85F),
                    0.12F * context.em);
        if (outcomeOf(event) == Outcome::Refused && width > 0.6F * context.em)
            drawShape(painter, {x + 0.5F * width, block.min.y + 0.5F * block.size.y},
                      0.5F * context.em, Shape::Cross,
                      painter.ink(&Palette::background, later ? 0.6F : 1.0F));
    }
}

std::string stageSummary(const StageRun& run) {
    std::string text(stageName(run.stage));
    const std::string section(stageSection(run.stage));
    text += section.empty() ? ", a rule beyond the paper\n" : ", section " + section + "\n";
    if (run.tests == 0) return text + grouped(run.size()) + (run.size() == 1 ? " step" : " steps");
    text += grouped(run.tests) + (run.tests == 1 ? " test, " : " tests, ");
    return text + grouped(run.refused) + " refused";
}

void drawStageBlock(const PanelContext& context, const StageRun& run, const Rect& block,
                    float textTop) {
    const float em = context.em;
    const bool here = run.contains(context.session().cursor());
    ScreenPainter painter(context);
    const Type type{kStageName * em};
    const std::string name(stageName(run.stage));
    // Of the stage at the cursor as much as fits; of the others the whole name or none.
    ImGui::PushClipRect({block.min.x, textTop}, {block.max().x + 0.3F * em, block.max().y}, true);
    if (here || painter.textSize(name, type).x <= block.size.x + 0.3F * em)
        painter.text({block.min.x, textTop}, name,
                     painter.ink(here ? &Palette::text : &Palette::textDim), type);
    ImGui::PopClipRect();
    drawTicks(context, run, block);
    if (here) frameHere(context, block);
    offerEvent(context, "##stage",
               {{block.min.x, textTop}, {std::max(1.0F, block.size.x), block.max().y - textTop}},
               run.begin);
    tooltip(stageSummary(run));
}

/// The wheel anywhere on a strip. Called first, so that items over it can be clicked.
void stepByWheel(const PanelContext& context, const Rect& area, const std::string& command) {
    const ImVec2 high = toVec2(area.max());
    if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(toVec2(area.min), high)) return;
    const float wheel = ImGui::GetIO().MouseWheel;
    if (wheel != 0.0F) context.run(command + (wheel > 0.0F ? "previous" : "next"));
}

// ---- STAGE: one cell per test -----------------------------------------------------------------

std::string cellText(const Event& event, std::span<const PointName> names, float room) {
    if (const auto* emit = std::get_if<EmitEvidence>(&event.evidence)) {
        // The whole number, even if the word is cut.
        const std::string number = grouped(emit->triangle);
        const std::string named = "triangle " + number;
        return ImGui::CalcTextSize(named.c_str()).x <= room ? named : number;
    }
    const Index subject = subjectOf(event);
    std::string text = subject == kNone ? std::string{} : nameOf(subject, names);
    if (const std::string_view ending = endingText(event); !ending.empty())
        text += (text.empty() ? "" : " ") + std::string(ending);
    if (const std::string_view word = wordOf(event); !word.empty()) {
        text += (text.empty() ? "" : " ") + std::string(word);
    }
    return text.empty() ? std::string(stageName(event.address.stage)) : text;
}

void drawCell(const PanelContext& context, const Rect& cell, std::size_t index) {
    const Session& session = context.session();
    const Event& event = session.record().events[index];
    const float em = context.em;
    const bool later = index > session.cursor();
    const Ink ink(cellColor(context, event));
    ScreenPainter painter(context);
    painter.box(cell, ink.withAlpha(later ? 0.1F : 0.22F), 0.2F * em);
    painter.box(cell.min, {cell.min.x + 0.22F * em, cell.max().y},
                ink.withAlpha(later ? 0.45F : 1.0F), 0.1F * em);
    const float middle = cell.min.y + 0.5F * cell.size.y;
    float x = cell.min.x + 0.45F * em;
    if (outcomeOf(event) == Outcome::Refused) {
        drawShape(painter, {x + 0.3F * em, middle}, 0.55F * em, Shape::Cross, ink);
        x += 0.8F * em;
    }
    const float room = cell.max().x - x - 0.1F * em;
    const std::string text =
        fitted(room < kSentenceFrom * em ? cellText(event, session.names(), room)
                                         : withShortNumbers(describe(event, session.names())),
               room);
    painter.text({x, middle - 0.5F * em}, text,
                 painter.ink(later ? &Palette::textDim : &Palette::text), {em});
    if (index == session.cursor()) frameHere(context, cell);
    offerEvent(context, "##cell", cell, index);
    if (ImGui::IsItemHovered()) {
        context.state<Navigation>().pointedAt = subjectOf(event);
        tooltip(toString(event.address) + "\n" + describe(event, session.names()));
    }
}

const StageRun* runAtCursor(const PanelContext& context) {
    const auto& runs = context.state<Navigation>().steps.runs();
    const std::size_t cursor = context.session().cursor();
    const auto at = std::find_if(runs.begin(), runs.end(),
                                 [&](const StageRun& run) { return run.contains(cursor); });
    return at == runs.end() ? nullptr : &*at;
}

}  // namespace

void drawPivotStrip(const PanelContext& context, const Rect& area) {
    Session& session = context.session();
    const float em = context.em;
    const float top = 1.35F * em;
    const Rect bars = beginStrip(context, "pivot", area, area.size.y - top - 0.45F * em, top);
    if (!session.ready()) return;
    stepByWheel(context, area, "step.pivot.");
    keepSteps(context);
    const auto& runs = context.state<Navigation>().steps.runs();
    if (runs.empty()) drawNone(context, bars, "No pivot yet.");
    const float gap = 0.5F * em;
    const std::vector<float> widths = widthsOf(context, runs, bars.size.x, gap);
    float x = bars.min.x;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        drawStageBlock(context, runs[i], {{x, bars.min.y}, {widths[i], bars.size.y}},
                       area.min.y + 0.3F * em);
        x += widths[i] + gap;
    }
}

void drawStageStrip(const PanelContext& context, const Rect& area) {
    const float em = context.em;
    const Rect bars = beginStrip(context, "stage", area, area.size.y - 0.75F * em, 0.2F * em);
    const Session& session = context.session();
    if (!session.ready()) return;
    stepByWheel(context, area, "step.event.");
    keepSteps(context);
    const StageRun* run = runAtCursor(context);
    if (run == nullptr) return drawNone(context, bars, "No decision yet.");
    // If there are too many: those around the cursor.
    const auto fits = static_cast<std::size_t>(std::max(1.0F, bars.size.x / (kLeastCell * em)));
    const std::size_t count = std::min(run->size(), fits);
    std::size_t first = run->begin;
    if (run->size() > count) {
        const std::size_t before = session.cursor() - run->begin;
        first += std::min(before - std::min(before, count / 2), run->size() - count);
    }
    const float pitch = bars.size.x / static_cast<float>(count);
    const float gap = std::min(0.3F * em, 0.1F * pitch);
    for (std::size_t i = 0; i < count; ++i) {
        const float x = bars.min.x + pitch * static_cast<float>(i);
        drawCell(context, {{x, bars.min.y}, {pitch - gap, bars.size.y}}, first + i);
    }
}

}  // namespace se::view
