/// The ancestry of a ring: lanes (ring_lanes.h) identify rings over a run, and each seed, split and
/// join is a node that names the nodes it was made of. The answer is the set of nodes reachable
/// from the ring. O(run up to the ring).
#include "spiraling_edge/why/ring_history.h"

#include <algorithm>
#include <map>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/ring_lanes.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se {

namespace {

bool isWholePivot(const RingAddress& ring) {
    return ring.at.stage == Stage::Pivot && ring.at.n == 0;
}

std::string addressOf(const RingAddress& ring) {
    return isWholePivot(ring) ? std::to_string(ring.at.pivot) : toString(ring.at);
}

}  // namespace

std::string nameOf(const RingAddress& ring) {
    return (ring.place == 0 ? "active ring" : "ring #" + std::to_string(ring.place)) + " at " +
           addressOf(ring);
}

Result<RingAddress> ringAddressFromString(std::string_view text) {
    const Error expected{inQuotes(text) +
                         ": expected an address, such as 137 for the active ring there, or "
                         "137#2 for the second on the stack."};
    const std::size_t sign = text.find('#');
    const auto at = addressFromString(text.substr(0, sign));
    if (!at) return expected;
    if (sign == std::string_view::npos) return RingAddress{*at, 0};
    const Index place = numberIn<Index>(text.substr(sign + 1)).value_or(0);
    if (place == 0) return expected;
    return RingAddress{*at, place};
}

namespace {

/// The event that made a ring, and those of the rings that it was made of.
struct Making {
    std::optional<LedgerLine> line;  ///< Nothing for a ring of a given start.
    std::vector<std::size_t> of;     ///< Earlier makings.
};

/// Follows the rings of a run by their lanes up to the place of the query, and collects the answer.
class RingFinder {
  public:
    RingFinder(const RingAddress& ring, const State& start, const Params& params)
        : ring_(ring), lanes_(params.paper.stack) {
        lanes_.begin(start.rings);
        for (const LaneChange& given : lanes_.takeChanges()) {
            made_[given.lane] = makings_.size();
            makings_.emplace_back();
        }
    }

    void add(const SweptPivot& pivot) {
        if (found_) return;
        for (const Event& event : pivot.events) {
            lanes_.take(event);
            for (const LaneChange& change : lanes_.takeChanges()) note(pivot.point, event, change);
            if (isThere(event.address)) return stop();
        }
        lanes_.settle(pivot.after.rings);
        lanes_.takeChanges();
        last_ = pivot.events.back().address.pivot;
        if (last_ == ring_.at.pivot && isWholePivot(ring_)) stop();
    }
    bool found() const { return found_; }

    Result<RingHistory> history() const {
        if (!found_)
            return Error{"The run has no " + addressOf(ring_) +
                         (ring_.at.pivot > last_
                              ? ": it ends with pivot " + std::to_string(last_) + "."
                              : ".")};
        if (!length_) {
            return Error{"There is no " + nameOf(ring_) + ": " +
                         (rings_ == 1 ? "1 ring is" : std::to_string(rings_) + " rings are") +
                         " there."};
        }
        if (lines_.empty()) {
            return Error{"The " + nameOf(ring_) +
                         " is one of the rings that the run begins with: no decision made it."};
        }
        RingHistory history{{.name = nameOf(ring_), .present = true, .lines = lines_}, *length_};
        history.cause = lines_.size() - 1;
        const Event& cause = lines_.back().event;
        history.answer = capitalized(history.name) + " has " + std::to_string(*length_) +
                         " points. " + describe(cause) + " (" + toString(cause.address) + ")";
        return history;
    }

  private:
    bool isThere(const Address& address) const {
        if (isWholePivot(ring_) || address.pivot != ring_.at.pivot) return false;
        return address.stage == ring_.at.stage && (ring_.at.n == 0 || address.n == ring_.at.n);
    }
    void stop() {
        found_ = true;
        rings_ = lanes_.live();
        const std::vector<LaneTracker::Ring>& stack = lanes_.stack();
        if (ring_.place > stack.size() || (ring_.place == 0 && !lanes_.active())) return;
        const LaneTracker::Ring& ring =
            ring_.place == 0 ? *lanes_.active() : stack[stack.size() - ring_.place];
        length_ = ring.length;
        lines_ = linesOf(ring.lane);
    }

    void note(Index pivot, const Event& event, const LaneChange& change) {
        const bool join = change.kind == LaneChangeKind::Join;
        if (!join && !beginsLane(change.kind)) return;
        Making making{LedgerLine{event, pivot, LineRole::Made, {}}, {}};
        if (join) making.of.push_back(made_.at(change.lane));
        if (change.kind != LaneChangeKind::Seed) making.of.push_back(made_.at(change.other));
        // A seed makes its ring, a split both of its rings, a join the one that remains.
        if (!join) made_[change.lane] = makings_.size();
        made_[change.other] = makings_.size();
        makings_.push_back(std::move(making));
    }
    /// All events in the ancestry of the ring of a lane, in the order of the run.
    std::vector<LedgerLine> linesOf(std::uint32_t lane) const {
        std::vector<bool> wanted(makings_.size(), false);
        wanted[made_.at(lane)] = true;
        std::vector<LedgerLine> lines;
        for (std::size_t i = makings_.size(); i-- > 0;) {
            if (!wanted[i]) continue;
            if (makings_[i].line) lines.push_back(*makings_[i].line);
            for (const std::size_t parent : makings_[i].of) wanted[parent] = true;
        }
        std::reverse(lines.begin(), lines.end());
        return lines;
    }

    RingAddress ring_;
    LaneTracker lanes_;
    std::vector<Making> makings_;
    std::map<std::uint32_t, std::size_t> made_;  ///< Per lane: the event that made its ring.
    bool found_ = false;
    std::uint32_t last_ = 0;  ///< The last pivot visited.
    std::size_t rings_ = 0;
    std::optional<Index> length_;
    std::vector<LedgerLine> lines_;
};

}  // namespace

Result<RingHistory> whyRing(const PointSet& points, const Params& params, const RingAddress& ring,
                            const Progress& progress) {
    RingFinder finder(ring, startState(points, params), params);
    // Events after the place are not needed.
    const auto goOn = [&](double share) {
        return !finder.found() && (!progress || progress(share));
    };
    const auto end = sweep(
        points, params, [&](const SweptPivot& pivot) { finder.add(pivot); }, goOn);
    if (!end && !finder.found()) return Error{"Cancelled."};
    return finder.history();
}

}  // namespace se
