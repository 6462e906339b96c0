// The Inspect panel: the numbers of the decision, then the selection.
#include <algorithm>
#include <cmath>

#include "panels/panel.h"
#include "panels/widgets/screen_painter.h"
#include "rows/evidence_rows.h"
#include "run/strings.h"
#include "scene/palette.h"
#include "session/selection_facts.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

namespace {

/// A bar with the value and its threshold, in the column of values.
void drawGauge(const PanelContext& context, const EvidenceGauge& bar, const Color& color) {
    if (!std::isfinite(bar.value) || !(bar.largest > 0.0)) return;
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(1);
    const float em = context.em;
    ImGui::Dummy({0.0F, 0.1F * em});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const glm::vec2 size(ImGui::GetContentRegionAvail().x, 0.5F * em);
    const auto x = [&](double value) {
        return at.x + size.x * static_cast<float>(std::clamp(value / bar.largest, 0.0, 1.0));
    };
    ScreenPainter p(context);
    p.box({{at.x, at.y}, size}, p.ink(&Palette::panelRaised), 0.12F * em);
    p.box({at.x, at.y}, {x(bar.value), at.y + size.y}, Ink(color), 0.12F * em);
    const float mark = std::round(x(bar.threshold));
    p.line({mark, at.y - 0.15F * em}, {mark, at.y + size.y + 0.15F * em},
           p.ink(&Palette::text).line(p.px(0.12F)));
    ImGui::Dummy({size.x, size.y + 0.2F * em});
}

std::string typeText(std::uint8_t type) {
    if (!isBoundary(type)) return "interior";
    if (isRimPoint(type)) return "boundary, on a rim";
    return (isCorner(type) ? "corner " : "boundary ") + wallsText(type);
}

std::string statusText(PointStatus status) {
    if (status == kUnused) return "UNUSED";
    if (status == kDone) return "DONE";
    return "USED, " + std::to_string(status) + (status == 1 ? " ring entry" : " ring entries");
}

void drawPoint(const PanelContext& context, const char* title, Index point) {
    const Session& session = context.session();
    const PointSet& points = session.shown().points;
    separator();
    const std::string name = nameOf(point, session.names());
    const std::string number = std::to_string(point);
    heading(context, title, "point " + number + (name == number ? "" : " (" + name + ")"));
    ImGui::PushID(title);
    if (beginValues("##point", context)) {
        valueRow(context, "status", statusText(session.picture().status[point]));
        const PrepareReport& report = session.model().report;
        const bool types = report.derived.types || report.derived.rim;
        const bool normals = report.derived.normals || report.derived.orientation;
        const bool lists = report.neighborsComputed;
        valueRow(context, types ? "type *" : "type", typeText(points.type[point]));
        valueRow(context, "position", numbersText(points.position[point]));
        valueRow(context, normals ? "normal *" : "normal", numbersText(points.normal[point]));
        const std::string list = joinedNumbers(points.neighbors[point]);
        valueRow(context, lists ? "neighbors *" : "neighbors", list.empty() ? "none" : list);
        // The star is at derived values.
        if (lists || types || normals)
            valueRow(context, "*", "derived, not from the input", context.palette.textDim);
        ImGui::EndTable();
    }
    ImGui::PopID();
}

/// Link to the pivot that made the thing, or a note that it is not known yet.
void drawCreation(const PanelContext& context, const SelectionFacts& facts, const char* thing) {
    const Session& session = context.session();
    const auto pivot = facts.number ? pivotOfTriangle(session.overview(), *facts.number)
                                    : std::optional<std::uint32_t>{};
    const std::string name(thing);
    if (!facts.present && pivot) {
        wrappedText("This " + name + " is not there yet: made at pivot " + std::to_string(*pivot) +
                    ".");
    } else if (!facts.present) {
        wrappedText("This " + name + " is not there at the cursor.");
    }
    if (!pivot) return;
    const std::string origin = toString(*originOfTriangle(session.overview(), *facts.number));
    if (ImGui::Button(("Go to " + origin + ", which made it").c_str())) context.run("step.birth");
    tooltip("Go to the decision that made it; Alt+Left returns");
}

void drawEdge(const PanelContext& context, const SelectionFacts& facts) {
    if (beginValues("##edge", context)) {
        const auto corners = context.session().selection().corners();
        valueRow(context, "points", joinedNumbers(corners));
        valueRow(context, "length", numberText(facts.length));
        std::string list;
        for (std::size_t i = 0; i < facts.triangles.size(); ++i) {
            list += (i == 0 ? "" : ", ") + std::to_string(facts.triangles[i]);
            if (i >= facts.trianglesPresent) list += " (later)";
        }
        valueRow(context, "triangles",
                 std::to_string(facts.trianglesPresent) + (list.empty() ? "" : ": " + list));
        valueRow(context, "ring", facts.ring.empty() ? "on none" : facts.ring);
        ImGui::EndTable();
    }
    drawCreation(context, facts, "edge");
}

void drawTriangle(const PanelContext& context, const SelectionFacts& facts) {
    if (beginValues("##triangle", context)) {
        const auto corners = context.session().selection().corners();
        valueRow(context, "number", facts.number ? std::to_string(*facts.number) : "repaired");
        valueRow(context, "corners", joinedNumbers(corners));
        valueRow(context, "angles", joined(facts.degrees, ", ", degreesText));
        valueRow(context, "area", numberText(facts.area));
        ImGui::EndTable();
    }
    drawCreation(context, facts, "triangle");
}

void drawSelection(const PanelContext& context) {
    const Selection& selection = context.session().selection();
    const SelectionFacts& facts = context.state<FactsCache>().of(context.session());
    if (selection.kind == SelectionKind::None) {
        ImGui::Spacing();
        return dimText("Click a point, an edge or a triangle to see its values here.");
    }
    if (selection.kind == SelectionKind::Point)
        return drawPoint(context, "Selected", selection.points[0]);
    separator();
    heading(context, "Selected", std::string(kindName(selection.kind)));
    selection.kind == SelectionKind::Edge ? drawEdge(context, facts) : drawTriangle(context, facts);
}

/// The evidence of an event as rows of values and thresholds.
void drawEvidence(const PanelContext& context, const Event& event) {
    if (!beginValues("##evidence", context)) return;
    const Session& session = context.session();
    const std::optional<Color> outcome = outcomeColor(context.palette, event);
    if (const std::string ending(endingText(event)); !ending.empty())
        valueRow(context, "verdict", ending, outcome.value_or(context.palette.text));
    // While the previous state is shown, the values stay those of the decision.
    std::optional<DecisionState> after;
    if (session.showsBefore()) after = session.replay().after(session.cursor());
    const EvidenceInput input{session.shown(), after ? *after : session.picture(), event,
                              &session.overview(), session.names()};
    for (const EvidenceRow& row : evidenceRows(input)) {
        valueRow(context, row.name.c_str(), row.value);
        if (row.gauge) drawGauge(context, *row.gauge, outcome.value_or(context.palette.accent));
    }
    ImGui::EndTable();
}

void drawStep(const PanelContext& context, const Event& event) {
    const std::string stage(stageName(event.address.stage));
    const std::string section = sectionOf(event);
    heading(context, stage.c_str(), section.empty() ? "not in the paper" : "paper " + section);
    ImGui::PushFont(context.fonts.mono);
    ImGui::TextDisabled("%s", toString(event.address).c_str());
    ImGui::PopFont();
    if (section.empty()) dimText("Not in the paper: docs/robust.md");
    ImGui::Spacing();
    drawEvidence(context, event);
}

}  // namespace

void drawInspect(const PanelContext& context) {
    const Session& session = context.session();
    if (const Event* event = session.event()) {
        drawStep(context, *event);
    } else {
        heading(context, "At the start");
        dimText(session.model().watch.empty() ? "All points are UNUSED. No triangle has been made."
                                              : session.model().watch);
    }
    // A selection is shown first.
    const bool picked = session.selection().kind != SelectionKind::None;
    if (picked) drawSelection(context);
    if (session.picture().pivot != kNone) drawPoint(context, "Pivot", session.picture().pivot);
    if (!picked) drawSelection(context);
}

}  // namespace se::view
