/// Moves to breakpoints, in either direction.
#include "moves.h"
#include "session.h"

namespace se::view {

std::string Moves::nameOf(const Stop& stop) const {
    const Breakpoint& breakpoint = session_.hits().wanted()[stop.breakpoint];
    const LineHits* known = session_.hits().of(breakpoint.line);
    const std::string all = known != nullptr && known->complete
                                ? " of " + std::to_string(known->list.total)
                                : std::string();
    const std::string& name = breakpoint.name.empty() ? breakpoint.line : breakpoint.name;
    return "Breakpoint " + name + ": hit " + std::to_string(stop.number) + all + ".";
}

void Moves::continueRun(int direction) {
    if (!session_.ready()) return;
    // From the target of the moves before it, unless that takes too long.
    if (busySeconds() > kLongMove) cancel();
    awaitedShare_.reset();
    awaitedStop_ = direction;
    waitingSince_ = Clock::now();
    session_.hits().resume();
    goToAwaitedStop();
}

/// Moves as soon as the position of the stop is known, or that there is none.
void Moves::goToAwaitedStop() {
    if (!awaitsStop() || waiting_ || !moves_.empty()) return;
    const int direction = awaitedStop_;
    const HitSearch::Answer answer = session_.hits().stop(session_.place(), direction);
    if (answer.known == HitSearch::Known::NotYet) return;
    awaitedStop_ = 0;
    if (answer.known == HitSearch::Known::GivenUp)
        return session_.messages().say("The search for breakpoints was stopped.");
    if (answer.stop) {
        goTo(answer.stop->hit.address);
        return session_.messages().say(nameOf(*answer.stop));
    }
    if (direction > 0) {
        toEnd();
    } else {
        toStart();
    }
}

void Moves::playToStop(const Stop& stop) {
    playTo(stop.hit.address);
    session_.messages().say(nameOf(stop));
}

}  // namespace se::view
