#include "step_rows.h"

#include <algorithm>
#include <array>

#include "paint/shapes.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/screen_painter.h"
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
        const float r = 0.27F * em();
        // From the middle to the tip, and to a corner of the other side.
        const glm::vec2 way = open ? glm::vec2(0.0F, r) : glm::vec2(r, 0.0F);
        const glm::vec2 across(-way.y, way.x);
        const glm::vec2 c(x_ + 0.4F * em(), middle());
        p_.polygon({c + 0.8F * way, c - 0.6F * way + across, c - 0.6F * way - across},
                   ink(context_.palette.textDim));
    }
    void text(const std::string& words, const Color& color, float end) {
        const std::string cut = fitted(words, end - x_);
        p_.text({x_, at_.y}, cut, textInk(color), {em()});
        x_ += textWidth(cut) + 0.5F * context_.em;
    }
    /// In a row with counts at its end.
    void label(const std::string& words, const Color& color) {
        text(words, color, columns_.labels);
    }
    /// Drawn whole or not at all.
    void labelIfItFits(const std::string& words, const Color& color) {
        if (x_ + textWidth(words) <= columns_.labels) label(words, color);
    }
    /// Ends at `width` from here.
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
                              Stage::CloseHole, Stage::Flip, Stage::Remesh, Stage::RemoveFolded}) {
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

}  // namespace

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

float stepArrowEnd(const PanelContext& context, const StepRow& row) {
    const float level = row.kind == StepRowKind::Component ? 0.0F
                        : row.kind == StepRowKind::Pivot   ? kIndent
                                                           : 2.0F * kIndent;
    return (level + kArrow) * context.em;
}

void drawStepRow(const PanelContext& context, const StepRow& row, ImVec2 at,
                 const StepColumns& columns) {
    RowPen pen(context, at, columns, isAhead(context, row) ? kAhead : 1.0F);
    constexpr std::array kDraw = {drawComponent, drawPivot, drawStage, drawTest};
    static_assert(static_cast<std::size_t>(StepRowKind::Test) + 1 == kDraw.size());
    kDraw[static_cast<std::size_t>(row.kind)](context, pen, row);
}

}  // namespace se::view
