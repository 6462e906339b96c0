#include "ask_actions.h"

#include <algorithm>
#include <array>
#include <vector>

#include "actions.h"
#include "alert_actions.h"
#include "compare/compared_runs.h"
#include "jobs/questions.h"
#include "panel_state/side_panels.h"
#include "run/strings.h"
#include "session/playback.h"
#include "session/session.h"
#include "session/view_position.h"
#include "spiraling_edge/points/index_ranges.h"
#include "spiraling_edge/run/reading.h"
#include "ui_state.h"

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
    c.ui.ledger.asked.reset();
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
    c.ui.ledger.asked = c.session.address();
    c.ui.ledger.complaint.clear();
    showPart(c, kLedgerPart);
    const Questions& questions = c.session.questions();
    const bool known =
        questions.subject() == what && (questions.ledger().busy() || questions.why() != nullptr);
    if (!known) c.session.questions().askWhy(what);
}

void askWhy(CommandContext& c, const RingAddress& ring) {
    if (!c.session.ready()) return;
    showLedger(c);
    c.session.questions().askWhy(ring);
}

void askWhy(CommandContext& c, const RunFailure& failure) {
    c.session.select(subjectOf(failure));
    showLedger(c);
    askInBackground(c, failure);
}

void askInBackground(CommandContext& c, const RunFailure& failure) {
    Questions& questions = c.session.questions();
    const Selection standIn = subjectOf(failure);
    if (questions.isAbout(failure.failure)) return;
    questions.askWhy(failure, c.session.alerts().found()->all, standIn);
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
    const Selection& selected = c.session.selection();
    const bool compares = c.ui.layoutPreset == LayoutPreset::Compare;
    // What is selected with a fault stands for it.
    const RunFailure* alert = c.session.alerts().shown();
    const bool nothing = selected.kind == SelectionKind::None;
    if (alert != nullptr && !compares && (nothing || subjectOf(*alert) == selected))
        return askWhy(c, *alert);
    if (!nothing) return askWhy(c, selected);
    if (compares)
        return c.session.messages().say(
            "Select a point, an edge or a triangle to ask both runs about.");
    showPart(c, kLedgerPart);
    c.ui.typing.open(TypedField::Ledger);
}

void toLedgerLine(CommandContext& c, int direction) {
    const Ledger* ledger = c.session.questions().why();
    if (ledger == nullptr) return askWhySelected(c);
    const auto line = positionAmong(ledger->lines, c.session).step(direction, ledger->lines.size());
    const std::string& name = ledger->name;
    if (!line) {
        return c.session.messages().say(direction > 0 ? "Nothing more happens to " + name + "."
                                                      : "Nothing happened to " + name + " before.");
    }
    jumpingMoves(c).goTo(ledger->lines[*line].event.address);
}

void toCause(CommandContext& c) {
    const Ledger* ledger = c.session.questions().why();
    if (ledger == nullptr) return askWhySelected(c);
    jumpingMoves(c).goTo(ledger->lines[ledger->cause].event.address);
}

void openQuery(CommandContext& c) {
    openPart(c, kQueryPart);
    c.ui.query.shown = QueryList::Found;
    c.ui.typing.open(TypedField::Query);
}

void toHit(CommandContext& c, int direction) {
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
    jumpingMoves(c).goTo(found->lines[*hit].event.address);
    // After the end of the list, a step back skips decisions that are not in it.
    if (cut && place.before == found->lines.size())
        c.session.messages().say(behindTheList(*found, c.session));
}

}  // namespace actions

namespace {

using QueryLine = std::optional<std::string>;

QueryLine withPoint(const BreakSubject& subject, const std::string& before,
                    const std::string& after = {}) {
    if (subject.point() == kNone) return std::nullopt;
    return before + std::to_string(subject.point()) + after;
}

QueryLine withEdge(const BreakSubject& subject) {
    if (subject.selected.kind != SelectionKind::Edge) return std::nullopt;
    const auto corners = subject.selected.corners();
    return "edge=" + std::to_string(corners[0]) + "," + std::to_string(corners[1]);
}

/// The stage, and the outcome of its test.
QueryLine thisKind(const BreakSubject& subject) {
    if (subject.event == nullptr) return std::nullopt;
    std::string line = "stage=" + std::string(stageName(subject.event->address.stage));
    const Outcome outcome = outcomeOf(*subject.event);
    if (outcome == Outcome::Taken) line += " kept";
    if (outcome == Outcome::Refused) line += " refused";
    return line;
}

constexpr std::array kPresets = {
    BreakPreset{"Point becomes USED", "a point",
                [](const BreakSubject& s) { return withPoint(s, "used="); }},
    BreakPreset{"Point becomes DONE", "a point",
                [](const BreakSubject& s) { return withPoint(s, "done="); }},
    BreakPreset{"Point is the pivot", "a point",
                [](const BreakSubject& s) { return withPoint(s, "pivot=", " stage=pivot"); }},
    BreakPreset{"Any decision about the point", "a point",
                [](const BreakSubject& s) { return withPoint(s, "point="); }},
    BreakPreset{"Edge enters the ring", "an edge", withEdge},
    BreakPreset{"This kind of decision", "a decision", thisKind},
    BreakPreset{"Ring splits", "", [](auto&) { return QueryLine("stage=split"); }},
    BreakPreset{"Rings join", "", [](auto&) { return QueryLine("stage=join"); }},
    BreakPreset{"Ring closes or is freed", "", [](auto&) { return QueryLine("closes"); }},
    BreakPreset{"Component ends", "", [](auto&) { return QueryLine("component"); }},
    BreakPreset{"Two-point ring is discarded", "",
                [](auto&) { return QueryLine("stage=twopoint refused"); }},
    BreakPreset{"Hole test removes a point", "",
                [](auto&) { return QueryLine("stage=hole refused"); }},
    BreakPreset{"A point is stranded", "", [](auto&) { return QueryLine("stranded"); }},
    BreakPreset{"Close decision", "", [](auto&) { return QueryLine("margin<1e-3"); }},
    BreakPreset{"Thin triangle", "", [](auto&) { return QueryLine("angle<15"); }},
    BreakPreset{"A failure appears", "", [](auto&) { return QueryLine("failure"); }},
    BreakPreset{"An alert is raised", "", [](auto&) { return QueryLine("alert"); }},
};

/// The line for "break here": the selection, otherwise this kind of decision. Empty at the start of
/// the run.
std::optional<std::string> lineHere(const BreakSubject& subject) {
    const auto corners = subject.selected.corners();
    if (corners.size() == 1) return "point=" + std::to_string(corners[0]);
    if (corners.size() == 2) return withEdge(subject);
    if (corners.size() == 3) {
        std::vector<Index> points(corners.begin(), corners.end());
        std::sort(points.begin(), points.end());
        return amongLine(points);
    }
    return thisKind(subject);
}

}  // namespace

Index BreakSubject::point() const {
    return selected.kind == SelectionKind::Point ? selected.points[0] : pivot;
}

std::span<const BreakPreset> breakPresets() { return kPresets; }

std::string amongLine(std::span<const Index> points) {
    return "among=" + rangesText(rangesOf(points));
}

BreakSubject breakSubject(const CommandContext& context) {
    const Session& session = context.session;
    if (!session.ready()) return {};
    return {session.selection(), session.event(), session.picture().pivot};
}

void addBreakpoint(CommandContext& context, Breakpoint breakpoint) {
    std::vector<Breakpoint>& all = context.ui.breakpoints;
    const auto same = std::find_if(all.begin(), all.end(), [&](const Breakpoint& each) {
        return each.line == breakpoint.line;
    });
    const std::string& name = breakpoint.name.empty() ? breakpoint.line : breakpoint.name;
    context.session.messages().say("Breakpoint: " + name + ".");
    if (same != all.end()) {
        same->on = true;
    } else {
        all.push_back(std::move(breakpoint));
    }
    context.session.hits().want(all);
}

namespace {

/// The last pivot that `count` steps may reach, and whether they may stop before its end.
bool passes(const CommandContext& context, const Stop& stop, int count) {
    const Session& session = context.session;
    const RunPosition here = session.place();
    const RunPosition there = stop.hit.place;
    const auto steps = static_cast<std::uint32_t>(count);
    const PlayUnit unit = context.playback.unit();
    if (unit == PlayUnit::Event) {
        const std::optional<Address> mark = session.nextMark(1);
        return !mark || there.pivot <= mark->pivot;
    }
    // Single steps near a stop are handled by the caller.
    return unit == PlayUnit::SubStep && there.pivot == here.pivot
               ? there.event <= here.event + steps
               : there.pivot <= here.pivot + steps;
}

}  // namespace

bool heldByBreakpoint(CommandContext& context, int count) {
    Session& session = context.session;
    if (!session.ready() || count <= 0) return false;
    const HitSearch::Answer ahead = session.hits().stop(session.place(), 1);
    if (ahead.known == HitSearch::Known::NotYet) return true;
    if (!ahead.stop || !passes(context, *ahead.stop, count)) return false;
    const bool inLaterPivot = ahead.stop->hit.place.pivot > session.place().pivot;
    const bool firstOfNext = ahead.stop->hit.place == RunPosition{session.place().pivot + 1, 0};
    if (context.playback.unit() == PlayUnit::SubStep && inLaterPivot && !firstOfNext) {
        // The number of events in between is known one pivot at a time.
        session.moves().stepEvent(1);
        return true;
    }
    session.moves().playToStop(*ahead.stop);
    context.playback.pause();
    return true;
}

namespace actions {

void continueBy(CommandContext& c, int direction) {
    c.session.hits().want(c.ui.breakpoints);
    jumpingMoves(c).continueRun(direction);
}

void toggleBreakpointHere(CommandContext& c) {
    const auto line = lineHere(breakSubject(c));
    if (!line)
        return c.session.messages().say(
            "No decision at the start of the run: select something to break on.");
    std::vector<Breakpoint>& all = c.ui.breakpoints;
    if (std::erase_if(all, [&](const Breakpoint& each) { return each.line == *line; }) > 0) {
        c.session.hits().want(all);
        return c.session.messages().say("Breakpoint removed: " + *line + ".");
    }
    addBreakpoint(c, {"", *line});
}

}  // namespace actions

}  // namespace se::view
