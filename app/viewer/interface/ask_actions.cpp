#include "ask_actions.h"

#include "command_actions.h"
#include "session/line_place.h"
#include "session/questions.h"

namespace se::view {

namespace {

/// The panel is in no sight where no panel is.
void openTab(CommandContext& c, const char* tab) {
    if (c.ui.arrangement == Arrangement::Present) actions::arrange(c, Arrangement::Debug);
    c.ui.wantedTab = tab;
}

}  // namespace

void askWhy(CommandContext& c, const Selection& what) {
    if (!c.session.ready() || what.kind == SelectionKind::None) return;
    c.session.select(what);
    c.ui.ledger.seen = what;
    c.ui.ledger.complaint.clear();
    openTab(c, kLedgerTab);
    const Questions& questions = c.session.questions();
    const bool known = questions.subject() == what &&
                       (questions.ledger().busy() || questions.ledger().answer() != nullptr);
    if (!known) c.session.questions().askWhy(what);
}

void askWhy(CommandContext& c, const RingPlace& ring) {
    if (!c.session.ready()) return;
    c.ui.ledger.seen = c.session.selection();
    c.ui.ledger.complaint.clear();
    openTab(c, kLedgerTab);
    c.session.questions().askWhy(ring);
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
    // The panel itself says what is wrong.
    static_cast<void>(c.session.questions().find(c.ui.query.typed));
}

void askQuery(CommandContext& c, const std::string& line) {
    c.ui.query.typed = line;
    openTab(c, kQueryTab);
    findTyped(c);
}

namespace actions {

void askWhySelected(CommandContext& c) {
    if (!c.session.ready()) return c.session.say("There is nothing open to ask about.");
    if (c.session.selection().kind != SelectionKind::None) return askWhy(c, c.session.selection());
    openTab(c, kLedgerTab);
    c.ui.ledger.wantsKeyboard = true;
}

void toLedgerLine(CommandContext& c, int direction) {
    if (!c.session.ready()) return;
    const WhyAnswer* ledger = c.session.questions().ledger().answer();
    if (ledger == nullptr) return askWhySelected(c);
    const auto line = placeAmong(ledger->lines, c.session).step(direction, ledger->lines.size());
    const std::string& name = ledger->name;
    if (!line) {
        return c.session.say(direction > 0 ? "Nothing more happens to " + name + "."
                                           : "Nothing happened to " + name + " before.");
    }
    pause(c);
    c.session.goTo(ledger->lines[*line].event.address);
}

void toCause(CommandContext& c) {
    if (!c.session.ready()) return;
    const WhyAnswer* ledger = c.session.questions().ledger().answer();
    if (ledger == nullptr) return askWhySelected(c);
    pause(c);
    c.session.goTo(ledger->lines[ledger->cause].event.address);
}

void openQuery(CommandContext& c) {
    openTab(c, kQueryTab);
    c.ui.query.shown = QueryList::Found;
    c.ui.query.wantsKeyboard = true;
}

void openClosest(CommandContext& c) {
    openTab(c, kQueryTab);
    c.ui.query.shown = QueryList::Closest;
}

void openCharts(CommandContext& c) { openTab(c, kChartsTab); }

void toHit(CommandContext& c, int direction) {
    if (!c.session.ready()) return;
    const FoundDecisions* found = c.session.questions().found().answer();
    if (found == nullptr) return openQuery(c);
    const auto hit = placeAmong(found->lines, c.session).step(direction, found->lines.size());
    if (!hit) {
        const bool cut = direction > 0 && found->total > found->lines.size();
        return c.session.say(
            cut             ? "That is the last one listed; at=A..B in the line lists those behind."
            : direction > 0 ? "Nothing more of the run is like that."
                            : "Nothing before is like that.");
    }
    pause(c);
    c.session.goTo(found->lines[*hit].event.address);
}

}  // namespace actions
}  // namespace se::view
