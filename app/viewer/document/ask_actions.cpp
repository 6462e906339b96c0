#include "ask_actions.h"

#include "actions.h"
#include "alert_actions.h"
#include "compare/compared_runs.h"
#include "jobs/questions.h"
#include "panel_state/side_panels.h"
#include "run/strings.h"
#include "session/line_position.h"

namespace se::view {

namespace {

/// Message at the end of a list if the run has more.
std::string behindTheList(const FoundDecisions& found, const Session& session) {
    const std::string from = std::to_string(found.lines.back().event.address.pivot);
    const std::string to = std::to_string(session.overview().lastPivot);
    return "The list ends here, with " + grouped(found.lines.size()) + " of " +
           grouped(found.total) + ": add at=" + from + ".." + to + " to the line for the rest.";
}

/// Shows the panel Ledger for a query about something else than the selection.
void showLedger(CommandContext& c) {
    c.ui.ledger.seen = c.session.selection();
    c.ui.ledger.complaint.clear();
    actions::showPart(c, kLedgerPart);
}

}  // namespace

using actions::openPart;
using actions::showPart;

void askWhy(CommandContext& c, const Selection& what) {
    if (!c.session.ready() || what.kind == SelectionKind::None) return;
    c.session.select(what);
    if (c.ui.layoutPreset == LayoutPreset::Compare) {
        // About both runs; the column beside the views has the answers.
        return c.compare.askWhy(what);
    }
    c.ui.ledger.seen = what;
    c.ui.ledger.complaint.clear();
    showPart(c, kLedgerPart);
    const Questions& questions = c.session.questions();
    const bool known = questions.subject() == what &&
                       (questions.ledger().busy() || questions.ledger().answer() != nullptr);
    if (!known) c.session.questions().askWhy(what);
}

void askWhy(CommandContext& c, const RingAddress& ring) {
    if (!c.session.ready()) return;
    showLedger(c);
    c.session.questions().askWhy(ring);
}

void askWhy(CommandContext& c, const RunFailure& failure) {
    const Selection subject = subjectOf(failure);
    if (subject.kind != SelectionKind::None) return askWhy(c, subject);
    showLedger(c);
    c.session.questions().askWhy(failure);
}

void askTyped(CommandContext& c) {
    LedgerPanel& panel = c.ui.ledger;
    panel.complaint.clear();
    if (const auto ring = ringFromText(panel.typed, c.session.address())) {
        if (!*ring) {
            panel.complaint = ring->error().message;
            return;
        }
        panel.typed.clear();
        return askWhy(c, ring->value());
    }
    const Result<Selection> what = selectionFromText(panel.typed, c.session.model().points.size());
    if (!what) {
        panel.complaint = what.error().message;
        return;
    }
    panel.typed.clear();
    askWhy(c, what.value());
}

void findTyped(CommandContext& c) {
    if (!c.session.ready()) return;
    c.ui.query.shown = QueryList::Found;
    // The panel itself reports the error.
    static_cast<void>(c.session.questions().find(c.ui.query.typed));
}

void askQuery(CommandContext& c, const std::string& line) {
    c.ui.query.typed = line;
    openPart(c, kQueryPart);
    findTyped(c);
}

namespace actions {

void askWhySelected(CommandContext& c) {
    if (!c.session.ready()) return c.session.messages().say("There is nothing open to ask about.");
    if (c.session.selection().kind != SelectionKind::None) return askWhy(c, c.session.selection());
    if (c.ui.layoutPreset == LayoutPreset::Compare)
        return c.session.messages().say(
            "Select a point, an edge or a triangle to ask both runs about.");
    if (const RunFailure* alert = c.session.alerts().shown()) return askWhy(c, *alert);
    showPart(c, kLedgerPart);
    c.ui.ledger.wantsKeyboard = true;
}

void toLedgerLine(CommandContext& c, int direction) {
    if (!c.session.ready()) return;
    const WhyAnswer* ledger = c.session.questions().ledger().answer();
    if (ledger == nullptr) return askWhySelected(c);
    const auto line = positionAmong(ledger->lines, c.session).step(direction, ledger->lines.size());
    const std::string& name = ledger->name;
    if (!line) {
        return c.session.messages().say(direction > 0 ? "Nothing more happens to " + name + "."
                                                      : "Nothing happened to " + name + " before.");
    }
    pause(c);
    c.session.moves().goTo(ledger->lines[*line].event.address);
}

void toCause(CommandContext& c) {
    if (!c.session.ready()) return;
    const WhyAnswer* ledger = c.session.questions().ledger().answer();
    if (ledger == nullptr) return askWhySelected(c);
    pause(c);
    c.session.moves().goTo(ledger->lines[ledger->cause].event.address);
}

void openQuery(CommandContext& c) {
    openPart(c, kQueryPart);
    c.ui.query.shown = QueryList::Found;
    c.ui.query.wantsKeyboard = true;
}

void openClosest(CommandContext& c) {
    openPart(c, kQueryPart);
    c.ui.query.shown = QueryList::Closest;
}

void toHit(CommandContext& c, int direction) {
    if (!c.session.ready()) return;
    const FoundDecisions* found = c.session.questions().found().answer();
    if (found == nullptr) return openQuery(c);
    const LinePosition place = positionAmong(found->lines, c.session);
    const auto hit = place.step(direction, found->lines.size());
    const bool cut = found->total > found->lines.size();
    if (!hit) {
        return c.session.messages().say(cut && direction > 0 ? behindTheList(*found, c.session)
                                        : direction > 0      ? "No later decision matches."
                                                             : "No earlier decision matches.");
    }
    pause(c);
    c.session.moves().goTo(found->lines[*hit].event.address);
    // After the end of the list, a step back skips decisions that are not in it.
    if (cut && place.before == found->lines.size())
        c.session.messages().say(behindTheList(*found, c.session));
}

}  // namespace actions
}  // namespace se::view
