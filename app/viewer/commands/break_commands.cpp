#include "break_commands.h"

#include <algorithm>

#include "panel_state/ui_state.h"
#include "session/playback.h"
#include "session/session.h"

namespace se::view {

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
