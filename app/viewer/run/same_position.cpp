// The two runs are stepped side by side and compared pivot by pivot (point, counters, new
// triangles, finished points), until they diverge. From there on a pivot number means nothing in
// the other run, so a pivot is identified by its component (the point that began it), its point,
// and how often that point has been pivot of the component. Costs the time of both runs, hence the
// thread of the loader.
#include "same_position.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se::view {

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
    if (place.kind == SamePosition::Kind::Start) return "At the start of the new run.";
    if (place.kind == SamePosition::Kind::End) return "At the end of the new run.";
    if (place.kind == SamePosition::Kind::Same) {
        if (was == now && place.part == 0) return "Same place: no difference before it.";
        if (was == now) return "Same place; the runs diverge at pivot " + part + ".";
        return "Same pivot, point " + std::to_string(place.point) + ": " + was + " is now " + now +
               "; the runs diverge at pivot " + part + ".";
    }
    std::string what = "pivot " + std::to_string(place.from.address.pivot);
    if (place.point != kNone) what += " (point " + std::to_string(place.point) + ")";
    return "The new run has no " + what + ": showing the last shared state, before pivot " + part +
           ".";
}

}  // namespace se::view
