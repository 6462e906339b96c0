#include "break_actions.h"

#include <algorithm>
#include <array>
#include <vector>

#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/points/index_ranges.h"
#include "spiraling_edge/run/reading.h"
#include "ui_state.h"

namespace se::view {

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

}  // namespace

Index BreakSubject::point() const {
    return selected.kind == SelectionKind::Point ? selected.points[0] : pivot;
}

std::span<const BreakPreset> breakPresets() { return kPresets; }

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
    switch (context.playback.unit()) {
        case PlayUnit::SubStep:
            // Single steps near a stop are handled by the caller.
            return there.pivot == here.pivot ? there.event <= here.event + steps
                                             : there.pivot <= here.pivot + steps;
        case PlayUnit::Pivot:
            return there.pivot <= here.pivot + steps;
        case PlayUnit::Event: {
            const std::optional<Address> mark = session.nextMark(1);
            return !mark || there.pivot <= mark->pivot;
        }
    }
    return false;
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
    c.playback.pause();
    if (!c.session.ready()) return;
    c.session.hits().want(c.ui.breakpoints);
    c.session.moves().continueRun(direction);
}

void toggleBreakpointHere(CommandContext& c) {
    if (!c.session.ready()) return;
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
