// The Query panel: a line of a query with completions, and the decisions that it finds.
#include <glm/geometric.hpp>

#include "document/ask_actions.h"
#include "input/key_routing.h"
#include "jobs/questions.h"
#include "panel_state/settings.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/decision_rows.h"
#include "panels/widgets/widgets.h"
#include "rows/evidence_rows.h"
#include "run/strings.h"
#include "scene/mesh_style.h"
#include "session/session.h"
#include "spiraling_edge/run/decision_query.h"

namespace se::view {

// ---- the line -------------------------------------------------------------------------------

std::string queryComplaint(const PanelContext& context, const std::string& line) {
    const auto mistake = mistakeIn(line);
    if (mistake) return mistake->message;
    return missingPointIn(line, context.session().model().points.size());
}

bool queryField(const PanelContext& context, const char* id, const char* hint, std::string& line) {
    const std::string complaint = queryComplaint(context, line);
    ImGui::PushFont(context.fonts.mono);
    if (!complaint.empty()) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
    const bool changed = textField(id, hint, line);
    if (!complaint.empty()) ImGui::PopStyleColor();
    ImGui::PopFont();
    if (line.size() > 20) tooltip(line.size() > 300 ? line.substr(0, 300) + " ..." : line);
    return changed;
}

void queryHelp(const PanelContext& context) {
    ImGui::TextDisabled("(?)");
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::TextUnformatted("All terms of a line must match:");
    if (ImGui::BeginTable("##terms", 2)) {
        for (const QueryTerm& term : queryTerms()) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            textIn(context.fonts.mono, std::string(term.form));
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(std::string(term.meaning).c_str());
        }
        ImGui::EndTable();
    }
    ImGui::EndTooltip();
}

// ---- the panel ------------------------------------------------------------------------------

namespace {

/// Example queries; each finds something on most inputs.
constexpr const char* kExamples[] = {"stage=sphere kept margin<1e-3", "refused section=6.1",
                                     "failure", "angle<10", "stage=split"};

/// The two lists of the panel, one of them visible.
void drawChoice(const PanelContext& context) {
    QueryPanel& panel = context.state<QueryPanel>();
    const auto choice = [&](const char* title, const char* name, QueryList list) {
        if (accentButton(context, panel.shown == list, title, name)) panel.shown = list;
    };
    choice("By terms", "query words", QueryList::Found);
    ImGui::SameLine();
    choice("Closest decisions", "query closest", QueryList::Closest);
}

/// Synchronizes the typed text with the suggestions.
void drawLine(const PanelContext& context) {
    QueryPanel& panel = context.state<QueryPanel>();
    const AskedLine line = askingLine(context, TypedField::Query, "stage=sphere kept margin<1e-4",
                                      panel.typed, "Find", "query box");
    panel.typing = line.active;
    if (line.asked) findTyped(context.commands);
}

/// Error of the line, as soon as there is one, except in the word that is being typed.
void drawMistake(const PanelContext& context) {
    const QueryPanel& panel = context.state<QueryPanel>();
    const std::string& asked = context.session().questions().line();
    const bool done = !panel.typing || panel.typed.ends_with(' ') || panel.typed == asked;
    const std::string complaint = queryComplaint(context, panel.typed);
    if (complaint.empty() || !done) return;
    wrappedText(complaint, context.palette.rejected);
}

void drawTerm(const PanelContext& context, const QueryTerm& term, bool wide) {
    QueryPanel& panel = context.state<QueryPanel>();
    const std::string form(term.form);
    const std::string meaning(term.meaning);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (ImGui::Selectable(form.c_str(), false, ImGuiSelectableFlags_SpanAllColumns)) {
        panel.typed = completed(panel.typed, term);
        context.state<TypingWait>().open(TypedField::Query);
    }
    if (ImGui::IsItemVisible()) nameItem(context, "term " + form);
    if (!wide) return tooltip(meaning);
    ImGui::TableNextColumn();
    dimText(meaning);
}

/// Completions of the last word; a click inserts one.
void drawTerms(const PanelContext& context) {
    const bool wide = ImGui::GetContentRegionAvail().x > 15.0F * context.em;
    if (!ImGui::BeginTable("##terms", wide ? 2 : 1, ImGuiTableFlags_SizingStretchSame)) return;
    if (wide) {
        ImGui::TableSetupColumn("form", ImGuiTableColumnFlags_WidthFixed, 7.6F * context.em);
        ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
    }
    for (const QueryTerm* term : termsFor(context.state<QueryPanel>().typed))
        drawTerm(context, *term, wide);
    ImGui::EndTable();
}

void drawLineHelp(const PanelContext& context) {
    QueryPanel& panel = context.state<QueryPanel>();
    dimText("Finds decisions of the whole run. All terms must match. Examples:");
    for (const char* example : kExamples) {
        if (!selectable(context, example, false, std::string("example ") + example)) continue;
        panel.typed = example;
        findTyped(context.commands);
    }
    ImGui::Spacing();
    dimText("All terms; click one to insert it:");
    drawTerms(context);
}

void drawFound(const PanelContext& context, const FoundDecisions& found) {
    std::string text = found.total == 0 ? "No decision matches." : withS(found.total, "decision");
    if (found.total != found.lines.size()) text += ", the first " + grouped(found.lines.size());
    ImGui::TextUnformatted(text.c_str());
    if (found.lines.empty()) return;
    const std::string keys = context.key("ask.hit.previous") + " / " + context.key("ask.hit.next");
    ImGui::SameLine();
    ImGui::TextDisabled("%s", keys.c_str());
    tooltip("To the previous / next one from the cursor");
    if (smallButton(context, "Break on these", "query break"))
        addBreakpoint(context.commands, {"", context.session().questions().line()});
    drawDecisionRows(context, {found.lines, context.state<QueryPanel>().found},
                     FrameRequest::Decision);
}

void drawByWords(const PanelContext& context) {
    const QueryPanel& panel = context.state<QueryPanel>();
    Questions& questions = context.session().questions();
    drawLine(context);
    drawMistake(context);
    const ScrolledBody body(context, "##queryBody");
    BackgroundQuery<FoundDecisions>& found = questions.found();
    // While the user types, the terms are more useful than the old results.
    if (panel.typing && panel.typed != questions.line()) return drawTerms(context);
    if (drawAsking(context, found)) return;
    if (!found.complaint().empty()) {
        dimText(found.complaint());
    } else if (const FoundDecisions* answer = found.answer()) {
        drawFound(context, *answer);
    } else {
        drawLineHelp(context);
    }
}

/// The move of a point, in short; the tooltip has it in full.
RowNote moveNote(const FlippingMove& move) {
    const std::string point = std::to_string(move.point);
    return {"moving " + point + formatted(" by %.2g flips it", glm::length(move.by)),
            "Moving " + point +
                formatted(" by (%.6g, %.6g, %.6g) flips it.", move.by.x, move.by.y, move.by.z)};
}

void drawNearestDecisions(const PanelContext& context, const ClosestAnswer& closest) {
    if (closest.lines.empty()) return dimText("No decision of this run compared a number.");
    dimText("The decisions closest to going the other way, closest first.");
    bool tinted = context.settings().pointTint == PointTint::Margin;
    if (ImGui::Checkbox("Tint points by margin", &tinted))
        context.run(tinted ? "view.points.margin" : "view.points.status");
    nameItem(context, "tint margin");
    const DecisionRows rows{
        closest.lines, context.state<QueryPanel>().closest, {}, false, [&](std::size_t i) {
            return moveNote(closest.decisions.decisions[i].move);
        }};
    drawDecisionRows(context, rows, FrameRequest::Decision);
}

void drawClosest(const PanelContext& context) {
    Questions& questions = context.session().questions();
    BackgroundQuery<ClosestAnswer>& closest = questions.closest();
    questions.requestClosest();
    const ScrolledBody body(context, "##closestBody");
    if (drawAsking(context, closest)) return;
    if (const ClosestAnswer* answer = closest.answer()) {
        drawNearestDecisions(context, *answer);
    } else {
        dimText(closest.complaint());
        if (ImGui::SmallButton("Retry")) closest.cancel();
    }
}

}  // namespace

void drawQuery(const PanelContext& context) {
    drawChoice(context);
    context.state<QueryPanel>().shown == QueryList::Found ? drawByWords(context)
                                                          : drawClosest(context);
}

}  // namespace se::view
