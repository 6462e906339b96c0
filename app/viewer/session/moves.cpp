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
        if (!together(wanted) || !oldAlone(wanted)) return false;
        place.part = part_;
        place.pivot = shared_;
        place.kind = SamePosition::Kind::Earlier;
        place.point = old_.point();
        if (place.point == kNone || old_.pivot() != wanted) return true;
        if (part_ == 0) {
            place.kind = SamePosition::Kind::Same;
            place.pivot = wanted;
            return true;
        }
        return find(place);
    }

  private:
    bool goOn() { return ++asked_ % kAskEvery != 0 || !keepGoing_ || keepGoing_(); }

    /// Both runs, up to the pivot or to the point where they diverge.
    bool together(std::uint32_t wanted) {
        while (part_ == 0 && old_.pivot() < wanted) {
            if (!goOn()) return false;
            const bool more = old_.next();
            const bool moreNew = new_.next();
            if (!more && !moreNew) return true;
            if (more != moreNew || !old_.didAs(new_)) {
                part_ = shared_ + 1;
            } else {
                shared_ = old_.pivot();
            }
            if (isIt(wanted)) found_ = new_.pivot();
        }
        return true;
    }
    bool oldAlone(std::uint32_t wanted) {
        while (old_.pivot() < wanted) {
            if (!goOn()) return false;
            if (!old_.next()) return true;
        }
        return true;
    }
    /// The runs diverge in the pivot that is searched for.
    bool isIt(std::uint32_t wanted) const {
        return old_.pivot() == wanted && new_.pivot() == wanted && isSame();
    }
    bool isSame() const {
        return new_.point() == old_.point() && new_.component() == old_.component() &&
               new_.times() <= old_.times();
    }
    /// The new run alone: the pivot with the same point, for the same number of times.
    bool find(SamePosition& place) {
        bool more = found_ == 0;
        while (more) {
            if (!goOn()) return false;
            if (isSame()) found_ = new_.pivot();
            if (found_ != 0 && new_.times() == old_.times() && isSame()) break;
            more = new_.next();
        }
        if (found_ == 0) return true;
        place.kind = SamePosition::Kind::Same;
        place.pivot = found_;
        return true;
    }

    Walk old_, new_;
    const std::function<bool()>& keepGoing_;
    std::uint32_t asked_ = 0;
    std::uint32_t shared_ = 0;  ///< Number of pivots that were equal in both.
    std::uint32_t part_ = 0;
    std::uint32_t found_ = 0;
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

std::size_t sameStep(const PivotRecord& record, const SamePosition& place) {
    const std::vector<Event>& events = record.events;
    if (events.empty()) return 0;
    if (place.kind != SamePosition::Kind::Same) return events.size() - 1;
    const Address& wanted = place.from.address;
    std::size_t best = events.size() - 1;
    int bestRank = -1;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Address& at = events[i].address;
        const bool about = subjectOf(events[i]) == place.from.subject;
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

constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();
/// A move shorter than this is made at once; during longer ones the window stays responsive.
constexpr std::chrono::milliseconds kAnswerTimeout{2};
/// Limit of waiting moves, so that key repeat does not pile them up.
constexpr std::size_t kMaxMoves = 64;

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
    landing_ = place ? Landing::AtSamePosition : Landing::Last;
    if (place) samePosition_ = *place;
    target_ = {};
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
    if (!answer->complaint.empty()) {
        waiting_ = false;
        moves_.clear();
        if (answer->record) session_.setCursorToLast();
        session_.messages().say(answer->complaint);
    } else if (answer->final) {
        waiting_ = false;
        if (landing_ == Landing::AtPoint && !answer->found) {
            landing_ = Landing::AtAddress;
            session_.messages().say("Nothing more happens to point " +
                                    std::to_string(pointWanted_) + " after this position.");
        }
        land();
    } else {
        session_.setCursorToLast();
    }
    return true;
}

void Moves::land() {
    std::size_t cursor = record().events.empty() ? 0 : record().events.size() - 1;
    if (landing_ == Landing::First) cursor = 0;
    if (landing_ == Landing::AtSamePosition) cursor = sameStep(record(), samePosition_);
    if (landing_ == Landing::AtPoint) {
        const auto found =
            std::find_if(record().events.begin(), record().events.end(),
                         [this](const Event& event) { return subjectOf(event) == pointWanted_; });
        if (found != record().events.end()) {
            cursor = static_cast<std::size_t>(found - record().events.begin());
        }
    }
    if (landing_ == Landing::AtAddress) cursor = findTarget();
    if (landing_ == Landing::Last && target_.pivot > record().pivot && target_.pivot != kEnd) {
        session_.messages().miss("There is no pivot " + std::to_string(target_.pivot) +
                                 ": the run ends with pivot " + std::to_string(record().pivot) +
                                 ".");
    }
    session_.setCursor(cursor);
}

/// The event at the target address; without one the last event before it.
std::size_t Moves::findTarget() {
    if (const auto found = record().find(target_)) return *found;
    const std::vector<Event>& events = record().events;
    const auto after = std::find_if(events.begin(), events.end(), [this](const Event& event) {
        return isBefore(target_, event.address);
    });
    const auto before =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - events.begin() - 1));
    const std::string shown = events.empty() ? "the start" : toString(events[before].address);
    session_.messages().miss("This run has no event " + toString(target_) + ". Shown: " + shown +
                             ".");
    return before;
}

void Moves::stepEvent(int delta) { push({Move::Kind::Events, delta, {}}); }
void Moves::stepPivot(int delta) { push({Move::Kind::Pivots, delta, {}}); }
void Moves::finishPivot() { push({Move::Kind::Finish, 0, {}}); }
void Moves::toEnd() { goToPivot(kEnd); }

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
    push({Move::Kind::Go, 0, address});
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
    push({Move::Kind::Point, 0, {}, point});
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
    moves_.push_back(move);
    processMoves();
}

void Moves::processMoves() {
    while (!waiting_ && !moves_.empty()) {
        const Move move = moves_.front();
        moves_.pop_front();
        perform(move);
    }
}

void Moves::perform(Move move) {
    switch (move.kind) {
        case Move::Kind::Events:
            return performEvents(move.delta);
        case Move::Kind::Pivots:
            return performPivots(move.delta);
        case Move::Kind::Point:
            return performPoint(move.point);
        case Move::Kind::Finish:
            if (session_.cursor() + 1 < record().events.size())
                return session_.setCursor(record().events.size() - 1);
            if (!session_.atLastPivot()) request(record().pivot + 1, Landing::Last);
            return;
        case Move::Kind::Go:
            const bool whole = move.target.stage == Stage::Pivot && move.target.n == 0;
            return request(move.target.pivot, whole ? Landing::Last : Landing::AtAddress,
                           move.target);
    }
}

void Moves::performPivots(int delta) {
    if (delta > 0 && session_.atLastPivot()) {
        if (!record().events.empty()) session_.setCursor(record().events.size() - 1);
        return;
    }
    const long to = static_cast<long>(record().pivot) + delta;
    request(static_cast<std::uint32_t>(std::max(0L, to)), Landing::Last);
}

void Moves::performEvents(int delta) {
    const auto count = static_cast<int>(record().events.size());
    const int here = count == 0 ? 0 : static_cast<int>(session_.cursor());
    const int to = here + delta;
    if (count > 0 && to >= 0 && to < count) {
        session_.setCursor(static_cast<std::size_t>(to));
    } else if (delta > 0 && !session_.atLastPivot()) {
        const int rest = count == 0 ? delta - 1 : to - count;
        if (rest > 0) moves_.push_front({Move::Kind::Events, rest, {}});
        request(record().pivot + 1, Landing::First);
    } else if (delta < 0 && record().pivot > 0) {
        if (to + 1 < 0) moves_.push_front({Move::Kind::Events, to + 1, {}});
        request(record().pivot - 1, Landing::Last);
    }
}

/// While there is a horizon, the length of the run and what follows are not searched.
bool Moves::stopsAtQuestion() {
    if (!session_.horizon()) return false;
    session_.messages().say("Answer the question, or show its answer, to go on.");
    return true;
}

void Moves::request(std::uint32_t pivot, Landing landing, const Address& target) {
    const std::optional<Address>& horizon = session_.horizon();
    const bool beyond = horizon && (pivot > horizon->pivot ||
                                    (target.pivot == horizon->pivot && isBefore(*horizon, target)));
    if (beyond && stopsAtQuestion()) return request(horizon->pivot, Landing::AtAddress, *horizon);
    landing_ = landing;
    target_ = target;
    if (session_.ready() && record().pivot == pivot) {
        land();
        return;
    }
    session_.runner_->request(pivot);
    await(pivot);
}

/// Waits briefly for the runner's answer.
void Moves::await(std::uint32_t pivot) {
    requested_ = pivot;
    waiting_ = true;
    waitingSince_ = Clock::now();
    session_.runner_->waitFor(kAnswerTimeout);
    takeAnswer();
}

void Moves::performPoint(Index point) {
    const auto isAbout = [point](const Event& event) { return subjectOf(event) == point; };
    const std::vector<Event>& events = record().events;
    const auto from = events.begin() +
                      static_cast<std::ptrdiff_t>(std::min(session_.cursor() + 1, events.size()));
    const auto found = std::find_if(from, events.end(), isAbout);
    if (found != events.end()) {
        session_.setCursor(static_cast<std::size_t>(found - events.begin()));
        return;
    }
    landing_ = Landing::AtPoint;
    target_ = session_.address();
    pointWanted_ = point;
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
