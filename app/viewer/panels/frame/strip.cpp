// The strip below the view: transport, the cells of the pivot, figures; below them the lanes of the
// run, and the decisions of the stage.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "document/actions.h"
#include "document/alert_actions.h"
#include "document/ui_state.h"
#include "paint/shapes.h"
#include "panel_state/settings.h"
#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/screen_painter.h"
#include "run/strings.h"
#include "session/playback.h"
#include "session/session.h"
#include "session/session_file.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/run/event_text.h"
#include "view_parts.h"

namespace se::view {

// The Bookmarks panel: addresses with the user's notes.

namespace {

/// The key of a bookmark, empty beyond the tenth.
std::string keyOf(const PanelContext& context, std::size_t place) {
    if (place >= kBookmarkKeys) return {};
    const Command* command = findCommand("notes.go." + std::to_string(place + 1));
    return command != nullptr ? context.key(*command) : std::string{};
}

/// One bookmark: its address (a link), the user's note, and a cross that removes it.
/// True if it is to be removed.
bool drawBookmark(const PanelContext& context, Bookmark& mark, std::size_t place) {
    const Session& session = context.session();
    const bool here =
        session.ready() && session.event() != nullptr && session.address() == mark.address;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string name = toString(mark.address);
    ImGui::PushFont(context.fonts.mono);
    ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0F, 0.5F});
    const bool chosen = ImGui::Selectable(name.c_str(), here, 0, {0.0F, ImGui::GetFrameHeight()});
    ImGui::PopStyleVar();
    if (chosen) jumpingMoves(context.commands).goTo(mark.address);
    ImGui::PopFont();
    const std::string key = keyOf(context, place);
    tooltip("Go to " + name + (key.empty() ? "" : " (" + key + ")"));
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0F);
    textField("##note", "note", mark.note);
    ImGui::TableNextColumn();
    const bool gone = ImGui::SmallButton("x");
    tooltip("Remove this bookmark");
    return gone;
}

void drawBookmarks(const PanelContext& context) {
    Bookmarks& marks = context.state<Bookmarks>();
    heading(context, "Bookmarks", marks.empty() ? "" : std::to_string(marks.size()));
    if (marks.empty()) {
        const std::string key = context.key("notes.bookmark");
        dimText(key + " sets or removes a bookmark at this decision.");
        return;
    }
    if (!ImGui::BeginTable("##marks", 3, ImGuiTableFlags_SizingStretchSame)) return;
    ImGui::TableSetupColumn("address", ImGuiTableColumnFlags_WidthFixed, 7.5F * context.em);
    ImGui::TableSetupColumn("note", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("away", ImGuiTableColumnFlags_WidthFixed, 1.4F * context.em);
    drawRemovable(marks,
                  [&](Bookmark& mark, std::size_t i) { return drawBookmark(context, mark, i); });
    ImGui::EndTable();
}

/// Bookmarks, and the user's own text.
void drawNotes(const PanelContext& context) {
    if (!context.session().ready()) return ImGui::TextDisabled("Nothing is open.");
    drawBookmarks(context);
    ImGui::Spacing();
    heading(context, "Notes");
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 size(room.x, std::max(6.0F * context.em, room.y - 2.0F * context.em));
    textArea("##notes", context.ui().notes, size);
    nameItem(context, "field notes");
    const std::string key = context.key("file.save");
    ImGui::TextDisabled("%s saves them in a session file.", key.c_str());
}

// The strips PIVOT, the stages of the pivot at the cursor, and STAGE, the events of one of them.

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

/// A text instead of cells, at the start of the run.
void drawNone(const PanelContext& context, const Rect& bars, const char* text) {
    const float y = bars.min.y + 0.5F * (bars.size.y - context.em);
    ImGui::GetWindowDrawList()->AddText({bars.min.x, y}, toU32(context.palette.textDim), text);
}

/// An item over a picture: a click goes to the event.
void offerEvent(const PanelContext& context, const char* id, const Rect& area, std::size_t event) {
    ImGui::SetCursorScreenPos(toVec2(area.min));
    ImGui::PushID(static_cast<int>(event));
    if (ImGui::InvisibleButton(id, toVec2(area.size))) context.pausedMoves().goToEvent(event);
    ImGui::PopID();
}

// ---- PIVOT: one block per stage ---------------------------------------------------------------

/// A stage is as wide as its tests, but at least as wide as its name, which keeps its room as long
/// as there is enough for all names.
std::vector<float> widthsOf(const PanelContext& context, const std::vector<StageRun>& runs,
                            float total, float gap) {
    std::vector<float> names;
    std::vector<float> widths;
    for (const StageRun& run : runs) {
        const float text =
            ScreenPainter(context)
                .textSize(std::string(stageName(run.stage)), {kStageName * context.em})
                .x;
        const float cells = static_cast<float>(run.size()) * 1.15F * context.em;
        names.push_back(text + 0.2F * gap);
        widths.push_back(std::max(names.back(), std::min(cells, 0.5F * total)));
    }
    const auto sum = [](const std::vector<float>& all) {
        return std::accumulate(all.begin(), all.end(), 0.0F);
    };
    const float room = total - gap * static_cast<float>(runs.size());
    const float least = std::max(1.0F, sum(names));
    const float share =
        std::clamp((room - least) / std::max(1.0F, sum(widths) - least), 0.0F, 1.0F);
    const float factor = std::min(1.0F, room / least);
    for (std::size_t i = 0; i < widths.size(); ++i)
        widths[i] = factor * (names[i] + share * (widths[i] - names[i]));
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
    if (run.tests == 0) return text + withS(run.size(), "step");
    return text + withS(run.tests, "test") + ", " + grouped(run.refused) + " refused";
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
    const glm::vec2 extent = painter.textSize(name, type);
    if (here || extent.x <= block.size.x + 0.3F * em) {
        painter.text({block.min.x, textTop}, name,
                     painter.ink(here ? &Palette::text : &Palette::textDim), type);
        context.where()["stage name " + name] = {{block.min.x, textTop}, extent};
    }
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
    return rowWhere(runs, [&](const StageRun& run) { return run.contains(cursor); });
}

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

// The transport: step, play, unit and speed.

/// Width from which unit and speed are there, in em.
constexpr float kWithSpeed = 20.0F;

constexpr std::array kBefore = {
    CommandButton{"##start", Icon::SkipStart, "run.start", "To the start"},
    CommandButton{"##pivotBack", Icon::Back, "step.pivot.previous", "Previous pivot"},
    CommandButton{"##back", Icon::StepBack, "step.event.previous", "Previous sub-step"}};
constexpr std::array kAfter = {
    CommandButton{"##on", Icon::StepForward, "step.event.next", "Next sub-step"},
    CommandButton{"##pivotOn", Icon::Forward, "step.pivot.next", "Next pivot"},
    CommandButton{"##end", Icon::SkipEnd, "run.end", "Run to the end"}};

CommandButton playButton(const PanelContext& context) {
    const bool playing = context.playback().playing();
    return {"##play", playing ? Icon::Pause : Icon::Play, "run.play", playing ? "Pause" : "Play"};
}

/// The unit of playback: a click changes to the next. As wide as the longest name, so that nothing
/// moves.
void drawUnit(const PanelContext& context) {
    float widest = 0.0F;
    for (const PlayUnit unit : {PlayUnit::SubStep, PlayUnit::Pivot, PlayUnit::Event})
        widest = std::max(widest, textWidth(std::string(unitName(unit))));
    const std::string name(unitName(context.playback().unit()));
    const float width = widest + 2.0F * ImGui::GetStyle().FramePadding.x;
    if (ImGui::Button((name + "##unit").c_str(), {width, 0.0F})) context.run("run.unit");
    tooltip(withKeys(context, "Unit of playback and single steps; click for the next", "run.unit"));
}

/// The five buttons that a finger needs, over the whole width.
void drawLarge(const PanelContext& context, const Rect& area) {
    const Session& session = context.session();
    const bool on = session.ready() && !session.atEnd();
    const std::array buttons = {kBefore[1], kBefore[2], playButton(context), kAfter[0], kAfter[1]};
    const float gap = 0.4F * context.em;
    const float width = (area.size.x - 6.0F * gap) / 5.0F;
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        ImGui::SetCursorScreenPos({area.min.x + gap + static_cast<float>(i) * (width + gap),
                                   area.min.y + 0.4F * context.em});
        const CommandButton& each = buttons[i];
        drawCommandButton(context, each, withKeys(context, each.text, each.command),
                          i < 2 ? !session.atStart() : on, i == 2,
                          {width, area.size.y - 0.8F * context.em});
    }
}

void drawTransport(const PanelContext& context, const Rect& area) {
    if (context.rects.phone) return drawLarge(context, area);
    const Session& session = context.session();
    const float em = context.em;
    const float high = ImGui::GetFrameHeight();
    ImGui::SetCursorScreenPos({area.min.x + 0.7F * em, area.min.y + 0.5F * (area.size.y - high)});
    ImGui::BeginGroup();
    drawButtons(context, kBefore, !session.atStart());
    const CommandButton play = playButton(context);
    drawCommandButton(context, play, withKeys(context, play.text, play.command),
                      session.ready() && !session.atEnd(), true);
    ImGui::SameLine(0.0F, 0.2F * em);
    drawButtons(context, kAfter, session.ready() && !session.atEnd());
    if (area.size.x > kWithSpeed * em) {
        ImGui::SameLine(0.0F, 0.7F * em);
        drawUnit(context);
        ImGui::SameLine(0.0F, 0.5F * em);
        drawSpeed(context, context.playback());
    }
    ImGui::EndGroup();
}

constexpr float kMargin = 0.75F;
constexpr float kFold = 1.4F;
constexpr float kNotes = 2.2F;

/// The triangles at the cursor, and what is known about the mesh at the end.
std::vector<std::string> figuresOf(const PanelContext& context) {
    const Session& session = context.session();
    const DecisionState& picture = session.picture();
    const std::string triangles =
        withS(picture.finishedTriangles + picture.newTriangles.size(), "triangle");
    if (!session.alerts().done()) return {triangles};
    return {triangles, endText(session)};
}

/// Counts of the run, right of the cells; the tooltip has those of the points.
void drawFigures(const PanelContext& context, const Rect& area) {
    if (area.size.x <= 0.0F || !context.session().ready()) return;
    const float em = context.em;
    const std::vector<std::string> lines = figuresOf(context);
    const float room = area.size.x - (kMargin + kFold + kNotes + 0.8F) * em;
    const float pitch = ImGui::GetTextLineHeight();
    float y = area.min.y + 0.5F * (area.size.y - pitch * static_cast<float>(lines.size()));
    ImGui::BeginGroup();
    for (const std::string& each : lines) {
        const std::string text = fitted(each, room);
        ImGui::SetCursorScreenPos({area.min.x + room - textWidth(text), y});
        ImGui::TextDisabled("%s", text.c_str());
        y += pitch;
    }
    ImGui::EndGroup();
    const StatusCounts& counts = context.counts;
    nameItem(context, "figures",
             "UNUSED " + grouped(counts.unused) + ", USED " + grouped(counts.used) + ", DONE " +
                 grouped(counts.done));
}

/// Bookmarks and notes, in a menu above the strip.
void drawNotesMenu(const PanelContext& context, const Rect& area) {
    const float em = context.em;
    ImGui::SetCursorScreenPos({area.max().x - (kMargin + kFold + kNotes) * em,
                               area.min.y + 0.5F * (area.size.y - ImGui::GetFrameHeight())});
    // On a phone the menu has it.
    const bool phone = context.rects.phone;
    const bool clicked =
        !phone && iconButton("##notesButton", Icon::Bookmark, "Bookmarks and your own text",
                             context.session().ready(), false, context);
    if (!phone) nameItem(context, "notes menu");
    const Rect place = phone ? Rect{{area.max().x, area.min.y}, {}} : lastItem();
    if (std::exchange(context.state<Navigation>().opensNotes, false) || clicked)
        ImGui::OpenPopup("##notes");
    ImGui::SetNextWindowPos({place.max().x, place.min.y - 0.3F * em}, ImGuiCond_Always,
                            {1.0F, 1.0F});
    ImGui::SetNextWindowSize({std::min(26.0F * em, context.rects.window.x), 20.0F * em});
    if (!ImGui::BeginPopup("##notes")) return;
    drawNotes(context);
    ImGui::EndPopup();
}

void drawFold(const PanelContext& context, const Rect& area) {
    const float em = context.em;
    const bool folded = context.rects.stripFolded;
    ImGui::SetCursorScreenPos(
        {area.max().x - (kMargin + kFold) * em, area.min.y + 0.5F * (area.size.y - kFold * em)});
    if (ImGui::InvisibleButton("##fold", {kFold * em, kFold * em})) context.run("view.strips");
    nameItem(context, "fold strips",
             std::string(folded ? "Show the lanes of the run, and the decisions of the stage ("
                                : "Fold the strips to this row (") +
                 context.key("view.strips") + ")");
    // A chevron that points up, where it unfolds, or down.
    const bool hovered = ImGui::IsItemHovered();
    const Rect square = lastItem();
    const glm::vec2 side(0.32F * em, (folded ? 0.16F : -0.16F) * em);
    const glm::vec2 tip = square.min + 0.5F * square.size - glm::vec2(0.0F, side.y);
    ScreenPainter p(context);
    if (hovered) p.box(square, p.ink(&Palette::panelRaised), 0.2F * em);
    const Ink ink = p.ink(hovered ? &Palette::text : &Palette::textDim).line(p.px(0.12F));
    p.line(tip + glm::vec2(-side.x, 2.0F * side.y), tip, ink);
    p.line(tip, tip + glm::vec2(side.x, 2.0F * side.y), ink);
}

}  // namespace

Rect beginStrip(const PanelContext& context, const char* name, const Rect& strip, float height,
                float top) {
    const float margin = kMargin * context.em;
    const Rect bars{{strip.min.x + margin, strip.min.y + top},
                    {std::max(1.0F, strip.size.x - 2.0F * margin), std::max(1.0F, height)}};
    context.where()[std::string("strip ") + name] = bars;
    return bars;
}

void keepSteps(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) return;
    context.state<Navigation>().steps.update(session.overview(), session.generation(),
                                             session.record(), session.cursor());
}

void drawStrip(const PanelContext& context) {
    const PanelRects& rects = context.rects;
    if (rects.strip.size.y <= 0.0F) return;
    if (beginRegion("##strip", rects.strip,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        const auto isThere = [](const Rect& each) {
            return each.size.x > 0.0F && each.size.y > 0.0F;
        };
        if (isThere(rects.transport)) drawTransport(context, rects.transport);
        if (isThere(rects.pivotStrip)) drawPivotStrip(context, rects.pivotStrip);
        if (isThere(rects.runStrip)) drawRunStrip(context, rects.runStrip);
        if (isThere(rects.stageStrip)) drawStageStrip(context, rects.stageStrip);
        drawFigures(context, rects.figures);
        if (isThere(rects.figures)) drawFold(context, rects.figures);
        if (isThere(rects.figures) || rects.phone)
            drawNotesMenu(context, rects.phone ? rects.strip : rects.figures);
    }
    ImGui::End();
}

}  // namespace se::view
