// The panel Why: the cause of a point, edge or triangle, by selection or by text.
#include "document/alert_actions.h"
#include "document/ask_actions.h"
#include "document/document.h"
#include "input/key_routing.h"
#include "jobs/questions.h"
#include "panel_state/side_panels.h"
#include "panel_state/what_if_offers.h"
#include "panels/widgets/decision_rows.h"
#include "panels/widgets/widgets.h"
#include "rows/evidence_rows.h"
#include "run/strings.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

namespace {

/// Query by text, which also finds things that are not in the view or not in the mesh.
void drawQuestionBox(const PanelContext& context) {
    LedgerPanel& panel = context.state<LedgerPanel>();
    const AskedLine line = askingLine(context, TypedField::Ledger, "812 or 812,640 or ring",
                                      panel.typed, "Why?", "ledger box");
    if (line.asked) askTyped(context.commands);
    if (!panel.complaint.empty()) wrappedText(panel.complaint, context.palette.rejected);
}

void drawEmpty(const PanelContext& context) {
    const std::string key = context.key("ask.why");
    dimText(
        "Why is it there? Why is it not? Click a point, an edge or a triangle in the "
        "view and press " +
        key + ", or right-click it.");
    ImGui::Spacing();
    dimText(
        "If it is not in the view, type its points above, such as 812,640 for an edge. Or select "
        "one "
        "point, and right-click the other.");
    ImGui::Spacing();
    dimText("Type ring for the cause of the active ring, ring #2 for the second on the stack.");
}

/// The answer of a ledger after the sentence of the decision that it was asked at, if that tested
/// the subject and is not the cause.
std::string answerAt(const std::optional<Address>& asked, const Ledger& ledger) {
    for (std::size_t i = 0; i < ledger.lines.size() && asked; ++i) {
        const LedgerLine& line = ledger.lines[i];
        const bool tests = line.role == LineRole::Taken || line.role == LineRole::Refused;
        if (line.event.address == *asked && tests && i != ledger.cause)
            return describe(line.event) + " (" + toString(*asked) + ")\n" + ledger.answer;
    }
    return ledger.answer;
}

/// The inverted decision of a proof, with a button that runs again so. True if it does.
bool drawInversions(const PanelContext& context, const Ledger& ledger) {
    if (ledger.inversions.empty()) return false;
    RunSpec inverted = context.session().input().rules();
    for (const WhatIf& each : ledger.inversions) {
        dimText("Inverted: " + lineOf(each));
        inverted = withWhatIf(inverted, each);
    }
    if (const RuleSetting* rule = ledger.undoneBy) {
        dimText("Switched off: " + std::string(rule->name));
        inverted = withRule(inverted, rule->name, 0.0);
    }
    sameLineFor({"Invert"});
    const bool clicked = smallButton(context, "Invert", "ledger invert",
                                     "Run again with what is said here inverted, as a what-if");
    if (clicked) context.document().rerun(inverted);
    return clicked;
}

void drawAnswer(const PanelContext& context, const Ledger& ledger) {
    const std::string answer = answerAt(context.state<LedgerPanel>().asked, ledger);
    ImGui::Spacing();
    wrappedText(withShortNumbers(answer));
    if (context.session().questions().isProving()) dimText("Looking for a proof ...");
    if (drawInversions(context, ledger)) return;
    if (ledger.preventedBy && drawPreventing(context, *ledger.preventedBy)) return;
    const Address& cause = ledger.lines[ledger.cause].event.address;
    if (ImGui::SmallButton("Go to the cause")) goToDecision(context, cause, FrameRequest::Focus);
    if (ImGui::IsItemVisible()) nameItem(context, "ledger cause", toString(cause));
    sameLineFor({"Copy as text"});
    if (ImGui::SmallButton("Copy as text")) {
        ImGui::SetClipboardText(ledgerText(answer, ledger.lines, ledger.cause).c_str());
        context.session().messages().say("Copied the answer and its " +
                                         grouped(ledger.lines.size()) + " lines.");
    }
    if (ImGui::IsItemVisible()) nameItem(context, "ledger copy");
    ImGui::Spacing();
    const ScrolledBody body(context, "##ledgerBody");
    DecisionRows rows{ledger.lines, context.state<LedgerPanel>().list, ledger.cause};
    rows.folds = context.session().questions().folds();
    drawDecisionRows(context, rows, FrameRequest::Focus);
}

/// While the panel is visible, each new selection is queried.
void followSelection(const PanelContext& context) {
    Session& session = context.session();
    Selection& seen = context.state<LedgerPanel>().seen;
    if (session.selection() == seen) return;
    seen = session.selection();
    const RunFailure* alert = session.alerts().shown();
    if (alert != nullptr && subjectOf(*alert) == seen)
        return askInBackground(context.commands, *alert);
    if (seen.kind == SelectionKind::None || seen == session.questions().subject()) return;
    context.state<LedgerPanel>().asked = session.address();
    session.questions().askWhy(seen);
}

}  // namespace

void drawLedger(const PanelContext& context) {
    Session& session = context.session();
    followSelection(context);
    Questions& questions = session.questions();
    partNote(questions.subjectName());
    drawQuestionBox(context);
    BackgroundQuery<Ledger>& ledger = questions.ledger();
    if (drawAsking(context, ledger)) return;
    if (!ledger.complaint().empty()) {
        dimText(ledger.complaint());
        if (ImGui::SmallButton("Retry")) questions.askAgain();
    } else if (const Ledger* answer = questions.why()) {
        drawAnswer(context, *answer);
    } else {
        drawEmpty(context);
    }
}

}  // namespace se::view
