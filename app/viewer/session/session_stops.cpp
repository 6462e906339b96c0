/// Moves to breakpoints, in either direction.
#include "session.h"

namespace se::view {

RunPosition Session::place() const {
    if (event() == nullptr) return {record_ ? record_->pivot : 0, 0};
    return {record_->pivot, static_cast<std::uint32_t>(cursor_)};
}

std::string Session::nameOf(const Stop& stop) const {
    const Breakpoint& breakpoint = hits_.wanted()[stop.breakpoint];
    const LineHits* known = hits_.of(breakpoint.line);
    const std::string all = known != nullptr && known->complete
                                ? " of " + std::to_string(known->list.total)
                                : std::string();
    const std::string& name = breakpoint.name.empty() ? breakpoint.line : breakpoint.name;
    return "Breakpoint " + name + ": hit " + std::to_string(stop.number) + all + ".";
}

void Session::continueRun(int direction) {
    if (!ready()) return;
    // From the target of the moves before it, unless that takes too long.
    if (busySeconds() > kLongMove) cancelMove();
    awaitedShare_.reset();
    awaitedStop_ = direction;
    waitingSince_ = Clock::now();
    hits_.resume();
    goToAwaitedStop();
}

/// Moves as soon as the position of the stop is known, or that there is none.
void Session::goToAwaitedStop() {
    if (!awaitsStop() || waiting_ || !moves_.empty()) return;
    const int direction = awaitedStop_;
    const HitSearch::Answer answer = hits_.stop(place(), direction);
    if (answer.known == HitSearch::Known::NotYet) return;
    awaitedStop_ = 0;
    if (answer.known == HitSearch::Known::GivenUp)
        return say("The search for breakpoints was stopped.");
    if (answer.stop) {
        goTo(answer.stop->hit.address);
        return say(nameOf(*answer.stop));
    }
    if (direction > 0) {
        toEnd();
    } else {
        toStart();
    }
}

void Session::playToStop(const Stop& stop) {
    playTo(stop.hit.address);
    say(nameOf(stop));
}

}  // namespace se::view
