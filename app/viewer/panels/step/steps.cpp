// The Steps panel: pivots, stages and events as a tree.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "input/key_routing.h"
#include "paint/shapes.h"
#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/screen_painter.h"
#include "panels/widgets/widgets.h"
#include "rows/step_tree.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"

namespace se::view {

namespace {

/// In em: one level of the tree, and its arrow.
constexpr float kIndent = 0.75F;
constexpr float kArrow = 1.0F;
/// In em: from the cross to the number of refused tests.
constexpr float kCross = 0.75F;
/// Rows after the cursor.
constexpr float kAhead = 0.55F;

std::string trianglesText(std::size_t number) { return "+" + grouped(number); }

/// Draws the parts of one row into the list, from left to right.
class RowPen {
  public:
    RowPen(const PanelContext& context, ImVec2 at, const StepColumns& columns, float alpha)
        : context_(context), p_(context), at_(at), x_(at.x), alpha_(alpha), columns_(columns) {}

    void indent(float em) { x_ += em * context_.em; }
    void arrow(bool open) {
        drawFoldArrow({x_ + 0.4F * em(), middle()}, 0.27F * em(), open,
                      ink(context_.palette.textDim).color);
    }
    void text(const std::string& words, const Color& color, float end) {
        const std::string cut = fitted(words, end - x_);
        p_.text({x_, at_.y}, cut, textInk(color), {em()});
        x_ += textWidth(cut) + 0.5F * context_.em;
    }
    /// Draws a label in a row with counts at its end.
    void label(const std::string& words, const Color& color) {
        text(words, color, columns_.labels);
    }
    /// Draws a label whole or not at all.
    void labelIfItFits(const std::string& words, const Color& color) {
        if (x_ + textWidth(words) <= columns_.labels) label(words, color);
    }
    /// Draws a text that ends `width` from here.
    void rightAligned(const std::string& words, float width, const Color& color) {
        endingAt(x_ + width, words, color);
        x_ += width + 0.5F * context_.em;
    }
    void shape(Shape shape, float size, const Color& color) {
        drawShape(p_, {x_ + 0.35F * context_.em, middle()}, size, shape, ink(color));
        x_ += 0.95F * context_.em;
    }
    void counts(std::size_t tests, std::size_t refused) {
        if (refused > 0) {
            const std::string number = grouped(refused);
            endingAt(columns_.refused, number, context_.palette.rejected);
            const float left = columns_.refused - textWidth(number);
            drawShape(p_, {left - 0.42F * em(), middle()}, 0.48F * em(), Shape::Cross,
                      ink(context_.palette.rejected));
        }
        if (tests > 0) endingAt(columns_.tests, grouped(tests), context_.palette.textDim);
    }
    void triangles(std::size_t number) {
        if (columns_.triangles <= 0.0F || number == 0) return;
        endingAt(columns_.triangles, trianglesText(number), context_.palette.textDim);
    }
    float end() const { return columns_.refused; }

  private:
    float em() const { return context_.em; }
    float middle() const { return at_.y + 0.5F * ImGui::GetTextLineHeight(); }
    Ink ink(const Color& color) const { return Ink(color.withAlpha(alpha_ * color.a)); }
    /// Text of a later row is dimmed, but readable; its marks are faint.
    Ink textInk(const Color& color) const {
        return Ink(alpha_ < 1.0F ? context_.palette.textDim : color);
    }
    void endingAt(float right, const std::string& words, const Color& color) {
        p_.text({right, at_.y}, words, textInk(color), {em(), Typeface::Text, Align::Right});
    }

    const PanelContext& context_;
    ScreenPainter p_;
    ImVec2 at_;
    float x_;
    float alpha_;
    StepColumns columns_;
};

std::string outcomeText(const Event& event) {
    if (const std::string_view ending = endingText(event); !ending.empty())
        return std::string(ending);
    if (const std::string_view word = wordOf(event); !word.empty()) return std::string(word);
    if (const auto* emit = std::get_if<EmitEvidence>(&event.evidence))
        return "triangle " + grouped(emit->triangle);
    return {};
}

Shape markOf(const Event& event) {
    if (outcomeOf(event) == Outcome::Refused ||
        std::holds_alternative<AlertEvidence>(event.evidence))
        return Shape::Cross;
    if (const auto* ring = std::get_if<RingEvidence>(&event.evidence))
        return ring->inserted ? Shape::Disc : Shape::Dot;
    return verdictOf(event) ? Shape::Disc : Shape::Dot;
}

/// Number made by the pivots first to last, in the part of the run known so far.
std::size_t trianglesBetween(const RunOverview& run, std::uint32_t first, std::size_t last) {
    last = std::min(last, run.triangles.size());
    if (first == 0 || first > last) return 0;
    return run.triangles[last - 1] - (first > 1 ? run.triangles[first - 2] : 0);
}

std::size_t trianglesOf(const RunOverview& run, std::uint32_t pivot) {
    return trianglesBetween(run, pivot, pivot);
}

std::size_t trianglesOfComponent(const RunOverview& run, std::size_t component) {
    const bool isLast = component + 1 >= run.components.size();
    return trianglesBetween(
        run, run.components[component].firstPivot,
        isLast ? run.triangles.size() : run.components[component + 1].firstPivot - 1);
}

/// Effect of a pivot on the rings, in one word.
std::string pivotNote(const PivotSummary& summary) {
    for (const Stage stage : {Stage::Finished, Stage::Split, Stage::Join, Stage::Done, Stage::Seed,
                              Stage::Skip, Stage::Fill, Stage::DropPatch, Stage::Reinsert,
                              Stage::CloseHole, Stage::Flip, Stage::Remesh}) {
        if ((summary.found & findingOf(stage)).any()) return std::string(stageName(stage));
    }
    return {};
}

void drawComponent(const PanelContext& context, RowPen& pen, const StepRow& row) {
    const StepTree& tree = context.state<Navigation>().steps;
    const ComponentSummary& component = context.session().overview().components[row.component];
    pen.arrow(tree.isOpen(row));
    pen.indent(kArrow);
    pen.triangles(trianglesOfComponent(context.session().overview(), row.component));
    pen.counts(component.tests, component.refused);
    pen.label("component " + grouped(row.component + 1), context.palette.text);
    pen.labelIfItFits(withS(tree.pivotsOf(row.component), "pivot"), context.palette.textDim);
}

void drawPivot(const PanelContext& context, RowPen& pen, const StepRow& row) {
    const RunOverview& run = context.session().overview();
    const StepTree& tree = context.state<Navigation>().steps;
    const PivotSummary& summary = run.pivots[row.pivot - 1];
    pen.indent(kIndent);
    pen.arrow(tree.isOpen(row));
    pen.indent(kArrow);
    pen.label(grouped(row.pivot), context.palette.text);
    std::string note = pivotNote(summary);
    if (row.pivot <= run.ringLength.size() && run.ringLength[row.pivot - 1] > 0) {
        const std::string ring = "ring " + grouped(run.ringLength[row.pivot - 1]);
        note = note.empty() ? ring : ring + ", " + note;
    }
    const std::size_t triangles = trianglesOf(run, row.pivot);
    if (summary.tests == 0 && triangles == 0) {
        // Nothing to count, as in a repair: the note may take the whole width.
        pen.text(note, context.palette.textDim, pen.end());
        return;
    }
    pen.label(note, context.palette.textDim);
    pen.triangles(triangles);
    pen.counts(summary.tests, summary.refused);
}

void drawStage(const PanelContext& context, RowPen& pen, const StepRow& row) {
    const StepTree& tree = context.state<Navigation>().steps;
    const StageRun& run = tree.runs()[row.run];
    const Event& event = context.session().record().events[row.event];
    pen.indent(2.0F * kIndent);
    if (tree.canOpen(row)) pen.arrow(tree.isOpen(row));
    pen.indent(kArrow);
    pen.label(std::string(stageName(run.stage)), context.palette.text);
    if (run.size() == 1) {
        if (outcomeOf(event) == Outcome::Refused)
            pen.shape(Shape::Cross, 0.52F * context.em, context.palette.rejected);
        const Index subject = subjectOf(event);
        const auto names = context.session().names();
        std::string note = subject == kNone ? std::string{} : nameOf(subject, names) + " ";
        // A single decision has no counts: the whole width is free.
        pen.text(note + outcomeText(event), context.palette.textDim, pen.end());
        return;
    } else if (run.tests == 0) {
        pen.label(grouped(run.size()), context.palette.textDim);
    }
    pen.counts(run.tests, run.refused);
}

void drawTest(const PanelContext& context, RowPen& pen, const StepRow& row) {
    const Session& session = context.session();
    const Event& event = session.record().events[row.event];
    const float em = context.em;
    const bool filtered = context.state<Navigation>().steps.filtered();
    pen.indent(filtered ? kIndent + kArrow : 3.0F * kIndent + 0.6F);
    if (filtered) {
        pen.text(
            std::string(stageName(event.address.stage)) + "." + std::to_string(event.address.n),
            context.palette.textDim, pen.end());
    } else {
        pen.rightAligned(std::to_string(event.address.n), 1.5F * em, context.palette.textDim);
    }
    const Index subject = subjectOf(event);
    const std::string digits(std::to_string(session.model().points.size()).size(), '0');
    if (subject != kNone)
        pen.rightAligned(nameOf(subject, session.names()), std::max(textWidth(digits), 2.0F * em),
                         context.palette.text);
    const Shape mark = markOf(event);
    const Color color = outcomeColor(context.palette, event).value_or(context.palette.text);
    pen.shape(mark, mark == Shape::Dot ? 0.28F * em : 0.52F * em, color);
    pen.text(outcomeText(event), color, pen.end());
}

bool isAhead(const PanelContext& context, const StepRow& row) {
    const Session& session = context.session();
    const std::uint32_t here = session.record().pivot;
    if (row.kind == StepRowKind::Component)
        return session.overview().components[row.component].firstPivot > std::max(1U, here);
    return row.kind == StepRowKind::Pivot ? row.pivot > here : row.event > session.cursor();
}

/// The columns of all rows from `left`, `room` wide. O(components).
StepColumns stepColumns(const PanelContext& context, float left, float room) {
    const RunOverview& run = context.session().overview();
    std::size_t triangles = 0;
    std::size_t tests = 0;
    std::size_t refused = 0;
    // A component has at least as many of each as any of its pivots.
    for (std::size_t i = 0; i < run.components.size(); ++i) {
        triangles = std::max(triangles, trianglesOfComponent(run, i));
        tests = std::max(tests, run.components[i].tests);
        refused = std::max(refused, run.components[i].refused);
    }
    return placeStepColumns(left, room, context.em,
                            {textWidth(trianglesText(triangles)), textWidth(grouped(tests)),
                             textWidth(grouped(refused)) + kCross * context.em});
}

std::string stepRowTooltip(const PanelContext& context, const StepRow& row) {
    const Session& session = context.session();
    const RunOverview& run = session.overview();
    if (row.kind == StepRowKind::Component) {
        const ComponentSummary& component = run.components[row.component];
        return "component " + grouped(row.component + 1) + ", from pivot " +
               grouped(component.firstPivot) + ", " +
               withS(context.state<Navigation>().steps.pivotsOf(row.component), "pivot") + "\n" +
               withS(component.tests, "test") + ", " + grouped(component.refused) + " refused";
    }
    if (row.kind == StepRowKind::Pivot) {
        const PivotSummary& summary = run.pivots[row.pivot - 1];
        std::string text = "pivot " + grouped(row.pivot);
        if (summary.point != kNone) text += " at point " + nameOf(summary.point, session.names());
        return text + "\n" + withS(trianglesOf(run, row.pivot), "triangle") + ", " +
               withS(summary.tests, "test") + ", " + grouped(summary.refused) + " refused";
    }
    const Event& event = session.record().events[row.event];
    return toString(event.address) + "\n" + describe(event, session.names());
}

/// Width from the left in which a click opens or folds the row.
float stepArrowEnd(const PanelContext& context, const StepRow& row) {
    const float level = row.kind == StepRowKind::Component ? 0.0F
                        : row.kind == StepRowKind::Pivot   ? kIndent
                                                           : 2.0F * kIndent;
    return (level + kArrow) * context.em;
}

/// By StepRowKind.
constexpr std::array kDrawKind = {drawComponent, drawPivot, drawStage, drawTest};
static_assert(static_cast<std::size_t>(StepRowKind::Test) + 1 == kDrawKind.size());

void goTo(const PanelContext& context, const StepRow& row) {
    Moves& moves = context.pausedMoves();
    if (row.kind == StepRowKind::Component) {
        context.state<Navigation>().steps.toggle(row);
    } else if (row.kind == StepRowKind::Pivot) {
        moves.goToPivot(row.pivot);
    } else {
        moves.goToEvent(row.event);
    }
}

/// Opens or folds a row; another pivot can only be opened by a move there.
void toggle(const PanelContext& context, const StepRow& row) {
    StepTree& tree = context.state<Navigation>().steps;
    if (row.kind == StepRowKind::Pivot && row.pivot != context.session().record().pivot) {
        goTo(context, row);
        tree.openPivot();
    } else {
        tree.toggle(row);
    }
}

/// Moves of the cursor, which the list of steps follows.
struct StepsWatch {
    CursorWatch cursor;
};

/// The user's action on a row.
enum class RowAction : std::uint8_t { None, Go, Toggle };

/// A click, or Enter, Left and Right for keyboard navigation.
RowAction actionOn(const PanelContext& context, const StepRow& row, bool pressed, float left) {
    const StepTree& tree = context.state<Navigation>().steps;
    const bool byMouse = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    if (pressed) {
        const bool onArrow = byMouse &&
                             ImGui::GetMousePos().x < left + stepArrowEnd(context, row) &&
                             tree.canOpen(row);
        return onArrow ? RowAction::Toggle : RowAction::Go;
    }
    if (!ImGui::IsItemFocused() || !tree.canOpen(row)) return RowAction::None;
    const auto hit = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    const bool wanted = tree.isOpen(row) ? hit(ImGuiKey_LeftArrow) : hit(ImGuiKey_RightArrow);
    return ImGui::GetIO().NavVisible && wanted ? RowAction::Toggle : RowAction::None;
}

RowAction drawRow(const PanelContext& context, std::size_t index, bool here, bool takes,
                  const StepColumns& columns) {
    const StepTree& tree = context.state<Navigation>().steps;
    const StepRow row = tree.row(index);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(index));
    const bool pressed = ImGui::Selectable("##row", here);
    if (takes) {
        takeKeyboard();
        if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    }
    if (ImGui::IsItemHovered()) {
        if (row.kind >= StepRowKind::Stage) {
            const Index subject = subjectOf(context.session().record().events[row.event]);
            context.state<Navigation>().pointedAt = subject;
            if (subject != kNone && ImGui::IsMouseReleased(ImGuiMouseButton_Right))
                context.state<SubjectMenu>().open(Selection::ofPoint(subject));
        }
        tooltip(stepRowTooltip(context, row));
    }
    RowPen pen(context, at, columns, isAhead(context, row) ? kAhead : 1.0F);
    kDrawKind[static_cast<std::size_t>(row.kind)](context, pen, row);
    const RowAction action = actionOn(context, row, pressed, at.x);
    ImGui::PopID();
    return action;
}

void drawStepFilter(const PanelContext& context) {
    Navigation& nav = context.state<Navigation>();
    ImGui::SetNextItemWidth(-1.0F);
    const bool wide = ImGui::GetContentRegionAvail().x > 16.0F * context.em;
    ImGui::InputTextWithHint("##filter", wide ? "filter: stage, verdict, point, x" : "filter",
                             nav.stepFilter.data(), nav.stepFilter.size());
    context.where()["steps filter"] = lastItem();
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
        tooltip(
            "Shows only pivots and tests with all of these words: the beginning of a stage "
            "(sphere), a word of a verdict (removed), the number of a point or pivot, or x for "
            "refused tests.");
    }
    nav.steps.setFilter(nav.stepFilter.data());
}

void drawColumnTitles(const PanelContext& context, const StepColumns& columns) {
    ScreenPainter painter(context);
    const float top = ImGui::GetCursorScreenPos().y;
    const auto title = [&](float right, const char* text) {
        if (right <= 0.0F) return;
        painter.text({right, top}, text, painter.ink(&Palette::textDim),
                     {0.78F * context.em, Typeface::Text, Align::Right});
    };
    title(columns.triangles, "triangles");
    title(columns.tests, "tests");
    title(columns.refused, "refused");
    ImGui::Dummy({0.0F, 0.75F * context.em});
}

/// Scrolls to the cursor's row if the cursor has moved away from it.
void followCursor(const PanelContext& context, float pitch) {
    const Session& session = context.session();
    CursorWatch& watch = context.state<StepsWatch>().cursor;
    if (!watch.moved(session.generation(), session.record().pivot, session.cursor())) return;
    // The start has no row: it is above the first.
    if (session.event() == nullptr) return ImGui::SetScrollY(0.0F);
    const auto row = context.state<Navigation>().steps.rowOfCursor();
    if (!row) return;
    const float top = static_cast<float>(*row) * pitch;
    const float height = ImGui::GetWindowHeight();
    const float scroll = ImGui::GetScrollY();
    if (top < scroll + 2.0F * pitch || top > scroll + height - 3.0F * pitch)
        ImGui::SetScrollY(std::floor(std::max(0.0F, top - 0.4F * height) / pitch) * pitch);
}

void drawStepRows(const PanelContext& context, const StepColumns& columns) {
    const StepTree& tree = context.state<Navigation>().steps;
    const float pitch = ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y;
    followCursor(context, pitch);
    const auto cursorRow = tree.rowOfCursor();
    RowAction action = RowAction::None;
    StepRow chosen;
    const bool keyboard = context.state<KeyWalk>().offer(KeyStop::Steps);
    const std::size_t first = cursorRow.value_or(0);
    const auto draw = [&](std::size_t row) {
        const RowAction wanted =
            drawRow(context, row, cursorRow == row, keyboard && row == first, columns);
        if (wanted == RowAction::None) return;
        action = wanted;
        chosen = tree.row(row);
    };
    drawSeen(tree.rowCount(), pitch, draw, keyboard ? std::optional(first) : std::nullopt);
    // After all rows: they may change here.
    if (action == RowAction::Go) goTo(context, chosen);
    if (action == RowAction::Toggle) toggle(context, chosen);
}

}  // namespace

void drawSteps(const PanelContext& context) {
    const Session& session = context.session();
    const RunOverview& run = session.overview();
    keepSteps(context);
    partNote(withS(run.ringLength.size(), "pivot") + (run.complete ? "" : "\xE2\x80\xA6"));
    drawStepFilter(context);
    const StepTree& tree = context.state<Navigation>().steps;
    const StepColumns columns =
        stepColumns(context, ImGui::GetCursorScreenPos().x,
                    ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize);
    drawColumnTitles(context, columns);
    if (tree.rowCount() == 0) {
        return dimText(tree.filtered() ? "No pivot has all of these words. Esc in the line above "
                                         "reverts the text."
                                       : "Nothing has happened yet. F10 steps by a pivot, F11 by "
                                         "a single decision.");
    }
    if (ImGui::BeginChild("##rows", {0, 0}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar)) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.2F * context.em});
        drawStepRows(context, columns);
        ImGui::PopStyleVar();
    }
    ImGui::EndChild();
}

}  // namespace se::view
