/// Moves of the cursor: carried out in order, by the runner thread where a pivot is not at hand.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "session.h"

namespace se::view {

namespace {

constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();
/// A move shorter than this is made at once; during longer ones the window stays responsive.
constexpr std::chrono::milliseconds kPatience{2};
/// Limit of waiting moves, so that key repeat does not pile them up.
constexpr std::size_t kMaxMoves = 64;

}  // namespace

bool Session::takeAnswer() {
    std::optional<RunnerAnswer> answer = runner_->take();
    if (!answer) return false;
    triangles_.insert(triangles_.end(), answer->newTriangles.begin(), answer->newTriangles.end());
    meshIndex_.append(*model_, triangles_);
    if (answer->record) record_ = answer->record;
    if (!answer->complaint.empty()) {
        waiting_ = false;
        moves_.clear();
        if (answer->record) setCursor(record_->events.empty() ? 0 : record_->events.size() - 1);
        say(answer->complaint);
    } else if (answer->final) {
        waiting_ = false;
        if (landing_ == Landing::AtPoint && !answer->found) {
            landing_ = Landing::AtAddress;
            say("Nothing more happens to point " + std::to_string(pointWanted_) +
                " after this position.");
        }
        land();
    } else {
        setCursor(record_->events.empty() ? 0 : record_->events.size() - 1);
    }
    return true;
}

void Session::land() {
    std::size_t cursor = record_->events.empty() ? 0 : record_->events.size() - 1;
    if (landing_ == Landing::First) cursor = 0;
    if (landing_ == Landing::AtSamePosition) cursor = sameStep(*record_, samePosition_);
    if (landing_ == Landing::AtPoint) {
        const auto found =
            std::find_if(record_->events.begin(), record_->events.end(),
                         [this](const Event& event) { return subjectOf(event) == pointWanted_; });
        if (found != record_->events.end()) {
            cursor = static_cast<std::size_t>(found - record_->events.begin());
        }
    }
    if (landing_ == Landing::AtAddress) {
        if (const auto found = record_->find(target_)) {
            cursor = *found;
        } else {
            miss("There is no event " + toString(target_) + ". Shown: the end of pivot " +
                 std::to_string(record_->pivot) + ".");
        }
    }
    if (landing_ == Landing::Last && target_.pivot > record_->pivot && target_.pivot != kEnd) {
        miss("There is no pivot " + std::to_string(target_.pivot) + ": the run ends with pivot " +
             std::to_string(record_->pivot) + ".");
    }
    setCursor(cursor);
}

bool Session::atEnd() const {
    return ready() && atLastPivot() && cursor_ + 1 >= record_->events.size();
}

bool Session::atLastPivot() const {
    return record_->isLast || (overview_.complete && record_->pivot >= overview_.lastPivot);
}

void Session::stepEvent(int delta) { push({Move::Kind::Events, delta, {}}); }
void Session::stepPivot(int delta) { push({Move::Kind::Pivots, delta, {}}); }
void Session::finishPivot() { push({Move::Kind::Finish, 0, {}}); }
void Session::toEnd() { goToPivot(kEnd); }

void Session::goToPivot(std::uint32_t pivot) { goTo({pivot, Stage::Pivot, 0}); }

void Session::goToShare(double share) {
    if (!ready()) return;
    cancelMove();
    awaitedShare_ = share;
    waitingSince_ = Clock::now();
    if (overview_.complete) goToAwaited();
}

/// The overview is complete, so a share of the run can be located.
void Session::goToAwaited() {
    if (!awaitedShare_) return;
    const double share = *std::exchange(awaitedShare_, std::nullopt);
    goToPivot(static_cast<std::uint32_t>(std::llround(overview_.lastPivot * share)));
}

void Session::goTo(const Address& address) {
    if (ready() && !busy()) history_.leave(hereText());
    jump(address);
}

void Session::jump(const Address& address) {
    cancelMove();
    push({Move::Kind::Go, 0, address});
}

std::string Session::hereText() const {
    return event() != nullptr ? toString(address()) : std::string("0");
}

void Session::goBack() {
    if (!ready()) return;
    const auto place = history_.back(hereText());
    if (place) jump(addressFromString(*place).value_or(Address{}));
}

void Session::goForward() {
    if (!ready()) return;
    const auto place = history_.forward(hereText());
    if (place) jump(addressFromString(*place).value_or(Address{}));
}

std::optional<Address> Session::nextMark(int direction) const {
    if (!ready()) return std::nullopt;
    const std::vector<RunMark>& marks = overview_.marks;  // by pivot, in the order of the run
    const Address here = address();
    const auto rank = [](const Address& place) {
        return std::tuple(place.pivot, place.stage, place.n);
    };
    const auto rankOf = [&rank](const RunMark& mark) {
        return rank({mark.pivot, stageOf(mark.kind), mark.n});
    };
    const auto at = event() != nullptr ? rank(here) : rank({0, Stage{}, 0});
    const RunMark* best = nullptr;
    for (const RunMark& mark : marks) {
        const auto place = rankOf(mark);
        const bool beyond = direction > 0 ? place > at : place < at;
        if (!beyond) continue;
        const bool nearer =
            best == nullptr || (direction > 0 ? place < rankOf(*best) : place > rankOf(*best));
        if (nearer) best = &mark;
    }
    if (best == nullptr) return std::nullopt;
    return Address{best->pivot, stageOf(best->kind), best->n};
}

bool Session::reached(const Address& address) const {
    if (!ready() || record_->pivot != address.pivot)
        return ready() && record_->pivot > address.pivot;
    const bool whole = address.stage == Stage::Pivot && address.n == 0;
    const auto place = whole ? std::nullopt : record_->find(address);
    return cursor_ >= place.value_or(record_->events.empty() ? 0 : record_->events.size() - 1);
}

void Session::goToPoint(Index point) {
    if (!ready()) return;
    if (!busy()) history_.leave(hereText());
    cancelMove();
    push({Move::Kind::Point, 0, {}, point});
}

void Session::goToEvent(std::size_t index) {
    if (busy() || !ready() || index >= record_->events.size()) return;
    setCursor(index);
}

double Session::busySeconds() const {
    if (!waiting_ && !awaitedShare_ && !awaitsStop()) return 0.0;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - waitingSince_;
    return time.count();
}

void Session::cancelMove() {
    moves_.clear();
    awaitedShare_.reset();
    awaitedStop_ = 0;
    if (waiting_) runner_->cancel();
}

void Session::push(Move move) {
    if (!runner_ || moves_.size() >= kMaxMoves) return;
    message_.clear();
    missed_ = false;
    awaitedShare_.reset();
    awaitedStop_ = 0;
    moves_.push_back(move);
    processMoves();
}

void Session::processMoves() {
    while (!waiting_ && !moves_.empty()) {
        const Move move = moves_.front();
        moves_.pop_front();
        perform(move);
    }
}

void Session::perform(Move move) {
    const std::uint32_t here = record_->pivot;
    switch (move.kind) {
        case Move::Kind::Events:
            performEvents(move.delta);
            break;
        case Move::Kind::Pivots: {
            const long to = static_cast<long>(here) + move.delta;
            if (move.delta > 0 && atLastPivot()) {
                if (!record_->events.empty()) setCursor(record_->events.size() - 1);
                break;
            }
            request(static_cast<std::uint32_t>(std::max(0L, to)), Landing::Last);
            break;
        }
        case Move::Kind::Finish:
            if (cursor_ + 1 < record_->events.size()) {
                setCursor(record_->events.size() - 1);
            } else if (!atLastPivot()) {
                request(here + 1, Landing::Last);
            }
            break;
        case Move::Kind::Point:
            performPoint(move.point);
            break;
        case Move::Kind::Go: {
            const bool whole = move.target.stage == Stage::Pivot && move.target.n == 0;
            request(move.target.pivot, whole ? Landing::Last : Landing::AtAddress, move.target);
            break;
        }
    }
}

void Session::performEvents(int delta) {
    const auto count = static_cast<int>(record_->events.size());
    const int here = count == 0 ? 0 : static_cast<int>(cursor_);
    const int to = here + delta;
    if (count > 0 && to >= 0 && to < count) {
        setCursor(static_cast<std::size_t>(to));
    } else if (delta > 0 && !atLastPivot()) {
        const int rest = count == 0 ? delta - 1 : to - count;
        if (rest > 0) moves_.push_front({Move::Kind::Events, rest, {}});
        request(record_->pivot + 1, Landing::First);
    } else if (delta < 0 && record_->pivot > 0) {
        if (to + 1 < 0) moves_.push_front({Move::Kind::Events, to + 1, {}});
        request(record_->pivot - 1, Landing::Last);
    }
}

void Session::request(std::uint32_t pivot, Landing landing, const Address& target) {
    landing_ = landing;
    target_ = target;
    if (record_ && record_->pivot == pivot) {
        land();
        return;
    }
    runner_->request(pivot);
    await(pivot);
}

/// Waits briefly for the runner's answer.
void Session::await(std::uint32_t pivot) {
    requested_ = pivot;
    waiting_ = true;
    waitingSince_ = std::chrono::steady_clock::now();
    runner_->waitFor(kPatience);
    takeAnswer();
}

void Session::performPoint(Index point) {
    const auto isAbout = [point](const Event& event) { return subjectOf(event) == point; };
    const std::vector<Event>& events = record_->events;
    const auto from =
        events.begin() + static_cast<std::ptrdiff_t>(std::min(cursor_ + 1, events.size()));
    const auto found = std::find_if(from, events.end(), isAbout);
    if (found != events.end()) {
        setCursor(static_cast<std::size_t>(found - events.begin()));
        return;
    }
    landing_ = Landing::AtPoint;
    target_ = address();
    pointWanted_ = point;
    runner_->requestPoint(point, record_->pivot);
    await(overview_.lastPivot);
}

}  // namespace se::view
