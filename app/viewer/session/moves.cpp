#include "moves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "run/strings.h"
#include "session.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se::view {

// The two runs are stepped side by side and compared pivot by pivot (point, counters, new
// triangles, finished points), until they diverge. From there on a pivot number means nothing in
// the other run, so a pivot is identified by its component (the point that began it), its point,
// and how often that point has been pivot of the component. Costs the time of both runs, hence the
// thread of the loader.

namespace {

constexpr std::uint32_t kAskEvery = 256;

/// Runs pivot by pivot and identifies each by its component, its point, and how often that was
/// pivot.
class Walk {
  public:
    explicit Walk(const RunInput& run)
        : stepper_(run.points, run.params), times_(run.points.size(), 0) {}

    const State& state() const { return stepper_.state(); }
    std::uint32_t pivot() const { return state().counters.pivots; }
    Index point() const { return point_; }
    Index component() const { return component_; }
    std::uint32_t times() const { return point_ == kNone ? 0 : times_[point_]; }

    /// Completes one more pivot. False if there is none.
    bool next() {
        bool seeded = false;
        while (state().phase == Phase::Seed) {
            seeded = true;
            stepper_.advance();
        }
        if (state().finished()) return false;
        triangles_ = state().triangles.size();
        done_ = state().done.size();
        point_ = state().phase == Phase::Pivot ? state().rings.point(state().pivot.pivot) : kNone;
        if (seeded) begin();
        if (point_ != kNone && times_[point_]++ == 0) touched_.push_back(point_);
        const std::uint32_t before = pivot();
        while (stepper_.stepPivot() && pivot() == before) {
        }
        return pivot() > before;
    }

    /// Whether the last pivot had the same effect in both runs.
    bool didAs(const Walk& other) const {
        const auto tail = [](const auto& list, std::size_t from) {
            return std::span(list).subspan(std::min(from, list.size()));
        };
        const auto made = tail(state().triangles, triangles_);
        const auto otherMade = tail(other.state().triangles, other.triangles_);
        const auto done = tail(state().done, done_);
        const auto otherDone = tail(other.state().done, other.done_);
        return point_ == other.point_ && state().counters == other.state().counters &&
               std::equal(made.begin(), made.end(), otherMade.begin(), otherMade.end()) &&
               std::equal(done.begin(), done.end(), otherDone.begin(), otherDone.end());
    }

  private:
    void begin() {
        component_ = point_;
        for (const Index p : touched_) times_[p] = 0;
        touched_.clear();
    }

    Stepper stepper_;
    /// Number of times that a point was pivot of this component.
    std::vector<std::uint32_t> times_;
    std::vector<Index> touched_;
    Index component_ = kNone;
    Index point_ = kNone;
    std::size_t triangles_ = 0;
    std::size_t done_ = 0;
};

class Search {
  public:
    Search(const RunInput& before, const RunInput& after, const std::function<bool()>& keepGoing)
        : old_(before), new_(after), keepGoing_(keepGoing) {}

    /// False if it was stopped.
    bool run(SamePosition& place) {
        const std::uint32_t wanted = place.from.address.pivot;
        place.kind = SamePosition::Kind::Earlier;
        if (!goTogether(wanted, place)) return false;
        while (old_.pivot() < wanted && old_.next()) {
            if (!goesOn()) return false;
        }
        place.point = old_.point();
        if (place.point == kNone || old_.pivot() != wanted) return true;
        if (place.part > 0) return find(place);
        place.kind = SamePosition::Kind::Same;
        return true;
    }

  private:
    bool goesOn() { return ++asked_ % kAskEvery != 0 || !keepGoing_ || keepGoing_(); }

    /// Both runs, up to the pivot or to the point where they diverge.
    bool goTogether(std::uint32_t wanted, SamePosition& place) {
        while (place.part == 0 && old_.pivot() < wanted) {
            if (!goesOn()) return false;
            const bool more = old_.next();
            const bool moreNew = new_.next();
            if (!more && !moreNew) return true;
            if (more == moreNew && old_.didAs(new_)) {
                place.pivot = old_.pivot();
            } else {
                place.part = place.pivot + 1;
            }
        }
        return true;
    }
    /// The new run alone: the pivot with the same point, for the same number of times; else the
    /// last one for fewer times.
    bool find(SamePosition& place) {
        do {
            if (!goesOn()) return false;
            const bool same = new_.point() == old_.point() && new_.component() == old_.component();
            if (!same || new_.times() > old_.times()) continue;
            place.kind = SamePosition::Kind::Same;
            place.pivot = new_.pivot();
            if (new_.times() == old_.times()) return true;
        } while (new_.next());
        return true;
    }

    Walk old_, new_;
    const std::function<bool()>& keepGoing_;
    std::uint32_t asked_ = 0;
};

}  // namespace

std::optional<SamePosition> findSamePosition(const RunInput& before, const CursorPosition& from,
                                             const RunInput& after,
                                             const std::function<bool()>& keepGoing) {
    SamePosition place;
    place.from = from;
    if (from.atEnd) {
        place.kind = SamePosition::Kind::End;
        place.pivot = std::numeric_limits<std::uint32_t>::max();
        return place;
    }
    if (from.address.pivot == 0) return place;
    if (!Search(before, after, keepGoing).run(place)) return std::nullopt;
    return place;
}

std::size_t eventLike(std::span<const Event> events, const Address& wanted, Index subject) {
    if (events.empty()) return 0;
    std::size_t best = events.size() - 1;
    int bestRank = -1;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Address& at = events[i].address;
        const bool about = subjectOf(events[i]) == subject;
        int rank = -1;
        if (at.stage == wanted.stage) {
            rank = at.n == wanted.n ? (about ? 4 : 2) : about ? 3 : 1;
        } else if (at.stage < wanted.stage) {
            rank = 0;
        }
        const bool better = rank > bestRank || (rank == 0 && bestRank == 0);
        if (rank >= 0 && better) {
            best = i;
            bestRank = rank;
        }
    }
    return best;
}

std::size_t sameStep(const PivotRecord& record, const SamePosition& place) {
    if (place.kind == SamePosition::Kind::Same)
        return eventLike(record.events, place.from.address, place.from.subject);
    return record.events.empty() ? 0 : record.events.size() - 1;
}

std::string describe(const SamePosition& place, const Address& landed) {
    const std::string was = toString(place.from.address);
    const std::string now = toString(landed);
    const std::string part = std::to_string(place.part);
    if (place.kind == SamePosition::Kind::Start) return "The new run is at its start.";
    if (place.kind == SamePosition::Kind::End) return "The new run is at its end.";
    if (place.kind == SamePosition::Kind::Same) {
        if (was == now && place.part == 0)
            return "This is the same decision; the runs do not differ before it.";
        if (was == now) return "This is the same address; the runs diverge at pivot " + part + ".";
        return "Same pivot, point " + std::to_string(place.point) + ": " + was + " is now " + now +
               "; the runs diverge at pivot " + part + ".";
    }
    std::string what = "pivot " + std::to_string(place.from.address.pivot);
    if (place.point != kNone) what += " (point " + std::to_string(place.point) + ")";
    return "The new run has no " + what + ": showing the last shared state, before pivot " + part +
           ".";
}

namespace {

constexpr std::uint32_t kEndOfRun = std::numeric_limits<std::uint32_t>::max();
/// A move shorter than this is made at once; during longer ones the window stays responsive.
constexpr std::chrono::milliseconds kAnswerTimeout{2};
/// Limit of waiting moves, so that key repeat does not pile them up.
constexpr std::size_t kMaxMoves = 64;

std::size_t lastEvent(const PivotRecord& record) {
    return record.events.empty() ? 0 : record.events.size() - 1;
}

/// The first event about a point, from a position in the list on; its size without one.
std::size_t eventAbout(Index point, const std::vector<Event>& events, std::size_t from) {
    const auto begin = events.begin() + static_cast<std::ptrdiff_t>(std::min(from, events.size()));
    const auto found = std::find_if(
        begin, events.end(), [point](const Event& event) { return subjectOf(event) == point; });
    return static_cast<std::size_t>(found - events.begin());
}

/// Moves the nearest position of `from` out, and `here` onto `to`.
std::optional<std::string> stepThrough(std::vector<std::string>& from, std::vector<std::string>& to,
                                       std::string here) {
    if (from.empty()) return std::nullopt;
    std::string place = std::move(from.back());
    from.pop_back();
    to.push_back(std::move(here));
    return place;
}

}  // namespace

void History::leave(std::string place) {
    after_.clear();
    if (!before_.empty() && before_.back() == place) return;
    before_.push_back(std::move(place));
    if (before_.size() > kMax) before_.erase(before_.begin());
}

std::optional<std::string> History::back(std::string here) {
    return stepThrough(before_, after_, std::move(here));
}

std::optional<std::string> History::forward(std::string here) {
    return stepThrough(after_, before_, std::move(here));
}

std::uint32_t Moves::runnerPosition() const {
    return session_.runner_ ? session_.runner_->position() : 0;
}

void Moves::open(const std::optional<SamePosition>& place) {
    moves_.clear();
    waiting_ = false;
    awaitedShare_.reset();
    awaitedStop_ = 0;
    landing_ = lastEvent;
    if (place) landing_ = [place](const PivotRecord& record) { return sameStep(record, *place); };
    takeAnswer();
}

bool Moves::poll() {
    const bool changed = waiting_ && takeAnswer();
    processMoves();
    return changed;
}

void Moves::wait() {
    if (waiting_) session_.runner_->waitFor(std::chrono::milliseconds(200));
}

const PivotRecord& Moves::record() const { return session_.record(); }

bool Moves::takeAnswer() {
    std::optional<RunnerAnswer> answer = session_.runner_->take();
    if (!answer) return false;
    session_.take(*answer);
    found_ = answer->found;
    if (!answer->complaint.empty()) {
        waiting_ = false;
        moves_.clear();
        if (answer->record) session_.setCursorToLast();
        session_.messages().say(answer->complaint);
    } else if (answer->final) {
        waiting_ = false;
        land();
    } else {
        session_.setCursorToLast();
    }
    return true;
}

void Moves::land() { session_.setCursor(landing_(record())); }

/// The event at an address; without one the last event before it.
std::size_t Moves::eventAt(const PivotRecord& record, const Address& target) {
    if (const auto found = record.find(target)) return *found;
    const std::vector<Event>& events = record.events;
    const auto after = std::find_if(events.begin(), events.end(), [&target](const Event& event) {
        return isBefore(target, event.address);
    });
    const auto before =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - events.begin() - 1));
    const std::string shown = events.empty() ? "the start" : toString(events[before].address);
    session_.messages().miss("This run has no event " + toString(target) + ". Shown: " + shown +
                             ".");
    return before;
}

/// The last event of a pivot, or of the run if that is shorter.
std::size_t Moves::lastOf(const PivotRecord& record, std::uint32_t pivot) {
    if (pivot > record.pivot && pivot != kEndOfRun) {
        session_.messages().miss("There is no pivot " + std::to_string(pivot) +
                                 ": the run ends with pivot " + std::to_string(record.pivot) + ".");
    }
    return lastEvent(record);
}

void Moves::stepEvent(int delta) {
    push([this, delta] { moveEvents(delta); });
}
void Moves::stepPivot(int delta) {
    push([this, delta] { movePivots(delta); });
}
void Moves::finishPivot() {
    push([this] { moveToLastEvent(); });
}
void Moves::toEnd() { goToPivot(kEndOfRun); }

void Moves::goToPivot(std::uint32_t pivot) { goTo({pivot, Stage::Pivot, 0}); }

void Moves::goToShare(double share) {
    if (!session_.ready() || stopsAtQuestion()) return;
    cancel();
    awaitedShare_ = share;
    waitingSince_ = Clock::now();
    if (session_.overview().complete) goToAwaited();
}

/// The run is made, so a share of it can be located.
void Moves::goToAwaited() {
    if (!awaitedShare_) return;
    const double share = *std::exchange(awaitedShare_, std::nullopt);
    if (!session_.overview().complete)
        return session_.messages().say(
            "The length of the run is not known: it was not made to its end.");
    goToPivot(static_cast<std::uint32_t>(std::llround(session_.overview().lastPivot * share)));
}

void Moves::goTo(const Address& address) {
    if (session_.ready() && !busy()) history_.leave(hereText());
    jump(address);
}

void Moves::jump(const Address& address) {
    cancel();
    push([this, address] { moveTo(address); });
}

std::string Moves::hereText() const {
    return session_.event() != nullptr ? toString(session_.address()) : std::string("0");
}

void Moves::jump(const std::optional<std::string>& place) {
    if (place) jump(addressFromString(*place).value_or(Address{}));
}

void Moves::goBack() {
    if (session_.ready()) jump(history_.back(hereText()));
}

void Moves::goForward() {
    if (session_.ready()) jump(history_.forward(hereText()));
}

void Moves::goToPoint(Index point) {
    if (!session_.ready() || stopsAtQuestion()) return;
    if (!busy()) history_.leave(hereText());
    cancel();
    push([this, point] { moveToPoint(point); });
}

void Moves::goToEvent(std::size_t index) {
    if (busy() || !session_.ready() || index >= record().events.size()) return;
    session_.setCursor(index);
}

double Moves::busySeconds() const {
    if (!waiting_ && !awaitedShare_ && !awaitsStop()) return 0.0;
    const std::chrono::duration<double> time = Clock::now() - waitingSince_;
    return time.count();
}

void Moves::cancel() {
    moves_.clear();
    awaitedShare_.reset();
    awaitedStop_ = 0;
    if (waiting_) session_.runner_->cancel();
}

void Moves::push(Move move) {
    // While a point is held, the cursor stays at its decision.
    if (!session_.runner_ || moves_.size() >= kMaxMoves || session_.drag().held()) return;
    session_.messages().clear();
    awaitedShare_.reset();
    awaitedStop_ = 0;
    moves_.push_back(std::move(move));
    processMoves();
}

void Moves::processMoves() {
    while (!waiting_ && !moves_.empty()) {
        const Move move = std::move(moves_.front());
        moves_.pop_front();
        move();
    }
}

void Moves::moveToLastEvent() {
    if (session_.cursor() + 1 < record().events.size())
        return session_.setCursor(record().events.size() - 1);
    if (!session_.atLastPivot()) request({record().pivot + 1, Stage{}, 0}, lastEvent);
}

void Moves::moveTo(const Address& target) {
    const bool whole = target.stage == Stage::Pivot && target.n == 0;
    request(target, [this, target, whole](const PivotRecord& record) {
        return whole ? lastOf(record, target.pivot) : eventAt(record, target);
    });
}

void Moves::movePivots(int delta) {
    if (delta > 0 && session_.atLastPivot()) {
        if (!record().events.empty()) session_.setCursor(record().events.size() - 1);
        return;
    }
    const long to = static_cast<long>(record().pivot) + delta;
    request({static_cast<std::uint32_t>(std::max(0L, to)), Stage{}, 0}, lastEvent);
}

void Moves::moveEvents(int delta) {
    const auto count = static_cast<int>(record().events.size());
    const int here = count == 0 ? 0 : static_cast<int>(session_.cursor());
    const int to = here + delta;
    const auto moveRest = [this](int rest) {
        if (rest != 0) moves_.push_front([this, rest] { moveEvents(rest); });
    };
    if (count > 0 && to >= 0 && to < count) {
        session_.setCursor(static_cast<std::size_t>(to));
    } else if (delta > 0 && !session_.atLastPivot()) {
        moveRest(count == 0 ? delta - 1 : to - count);
        request({record().pivot + 1, Stage{}, 0},
                [](const PivotRecord&) { return std::size_t{0}; });
    } else if (delta < 0 && record().pivot > 0) {
        moveRest(to + 1);
        request({record().pivot - 1, Stage{}, 0}, lastEvent);
    }
}

/// While there is a horizon, the length of the run and what follows are not searched.
bool Moves::stopsAtQuestion() {
    if (!session_.horizon()) return false;
    session_.messages().say("Answer the question, or show its answer, to go on.");
    return true;
}

/// Goes to the pivot of an address, at most to the open question.
void Moves::request(const Address& target, Landing landing) {
    const std::optional<Address> horizon = session_.horizon();
    if (horizon && isBefore(*horizon, target) && stopsAtQuestion()) return moveTo(*horizon);
    landing_ = std::move(landing);
    if (session_.ready() && record().pivot == target.pivot) return land();
    session_.runner_->request(target.pivot);
    await(target.pivot);
}

/// Waits briefly for the runner's answer.
void Moves::await(std::uint32_t pivot) {
    requested_ = pivot;
    waiting_ = true;
    waitingSince_ = Clock::now();
    session_.runner_->waitFor(kAnswerTimeout);
    takeAnswer();
}

void Moves::moveToPoint(Index point) {
    const std::vector<Event>& events = record().events;
    const std::size_t next = eventAbout(point, events, session_.cursor() + 1);
    if (next < events.size()) return session_.setCursor(next);
    landing_ = [this, point, here = session_.address()](const PivotRecord& record) {
        if (found_) return std::min(eventAbout(point, record.events, 0), lastEvent(record));
        session_.messages().say("Nothing more happens to point " + std::to_string(point) +
                                " after this position.");
        return eventAt(record, here);
    };
    session_.runner_->requestPoint(point, record().pivot);
    await(session_.overview().lastPivot);
}

// Moves to breakpoints, in either direction.

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
    if (!session_.ready() || stopsAtQuestion()) return;
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

// Positions as the user types them.

Status Moves::goToText(const std::string& given) {
    const std::string text = trimmed(given);
    const Error unknown{inQuotes(text) +
                        " is not an address. Examples: 137, 137.sphere.3, +10, 50%, p812."};
    if (!session_.ready() || text.empty()) return unknown;
    if (text.front() == '+' || text.front() == '-') {
        const auto number =
            numberIn<long>(std::string_view(text).substr(text.front() == '+' ? 1 : 0));
        if (!number || std::abs(*number) > 1'000'000'000L) return unknown;
        stepPivot(static_cast<int>(*number));
        return success();
    }
    if (text.back() == '%') {
        const auto share = numberIn<long>(std::string_view(text).substr(0, text.size() - 1));
        if (!share || *share < 0 || *share > 100) return unknown;
        goToShare(static_cast<double>(*share) / 100.0);
        return success();
    }
    if (text.front() == 'p') {
        const auto point = numberIn<long>(std::string_view(text).substr(1));
        if (!point || *point < 0) return unknown;
        if (static_cast<std::size_t>(*point) >= session_.model().points.size()) {
            return Error{"There is no point " + std::to_string(*point) + "; the last one is " +
                         std::to_string(session_.model().points.size() - 1) + "."};
        }
        session_.select(static_cast<Index>(*point));
        goToPoint(static_cast<Index>(*point));
        return success();
    }
    const std::optional<Address> address = addressFromString(text);
    if (!address) return unknown;
    goTo(*address);
    return success();
}

}  // namespace se::view
