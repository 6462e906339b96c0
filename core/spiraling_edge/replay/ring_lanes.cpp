/// A replay of the ring stack from events alone. Events carry lengths, not rings: where a split,
/// join or close may concern the active ring or one pushed by the same pivot, the length that fits
/// decides. Freed lanes go to a heap, so that the least free number is reused. O(1) per event,
/// O(log lanes) per lane.
#include "spiraling_edge/replay/ring_lanes.h"

#include <algorithm>
#include <utility>

namespace se {

const char* laneChangeText(LaneChangeKind kind) {
    switch (kind) {
        case LaneChangeKind::Seed:
            return "seed";
        case LaneChangeKind::Split:
            return "split off";
        case LaneChangeKind::Activated:
            return "comes off the stack";
        case LaneChangeKind::Join:
            return "joined";
        case LaneChangeKind::Closed:
            return "closed";
        case LaneChangeKind::Freed:
            return "ends at a boundary";
        case LaneChangeKind::Hole:
            return "ends at an open hole";
    }
    return "";
}

std::uint32_t lanesAt(std::span<const LaneChange> changes, std::uint32_t pivot) {
    const auto next = std::upper_bound(
        changes.begin(), changes.end(), pivot,
        [](std::uint32_t p, const LaneChange& change) { return p < change.pivot; });
    return next == changes.begin() ? 0 : std::prev(next)->live;
}

std::vector<LaneChange> LaneTracker::takeChanges() { return std::exchange(changes_, {}); }

void LaneTracker::take(const Event& event) {
    pivot_ = event.address.pivot;
    std::visit([this](const auto& evidence) { take(evidence); }, event.evidence);
}

void LaneTracker::note(LaneChangeKind kind, std::uint32_t lane, std::uint32_t other) {
    changes_.push_back({pivot_, lane, other, live(), kind});
}

std::uint32_t LaneTracker::freeLane() {
    if (free_.empty()) return lanes_++;
    const std::uint32_t lane = free_.top();
    free_.pop();
    return lane;
}

void LaneTracker::take(const SeedEvidence&) {
    active_ = Ring{freeLane(), 2, false};
    note(LaneChangeKind::Seed, active_->lane, active_->lane);
}

void LaneTracker::beginPivot(Index ringLength) {
    if (active_) active_->length = ringLength;
    for (auto ring = stack_.rbegin(); ring != stack_.rend() && ring->fresh; ++ring) {
        ring->fresh = false;
    }
    closing_ = 0;
}

void LaneTracker::take(const PivotEvidence& pivot) { beginPivot(pivot.ringLength); }
void LaneTracker::take(const FillEvidence& fill) { beginPivot(fill.ringLength); }

void LaneTracker::take(const InsertEvidence& insert) {
    const bool inserted = insert.verdict == Verdict::Before || insert.verdict == Verdict::After;
    if (active_ && inserted) ++active_->length;
}

void LaneTracker::take(const RingEvidence& ring) {
    if (closing_ > 0) {
        --closing_;
    } else if (active_) {
        active_->length += ring.inserted ? 1U : Index(-1);
    }
}

std::optional<std::size_t> LaneTracker::freshOfLength(Index length) const {
    for (std::size_t i = stack_.size(); i-- > 0 && stack_[i].fresh;) {
        if (stack_[i].length == length) return i;
    }
    return std::nullopt;
}

void LaneTracker::take(const SplitEvidence& split) {
    if (!active_) return;
    const Index whole = split.activeLength + split.stackedLength;
    Ring* parent = &*active_;
    if (active_->length != whole) {
        // A ring that an earlier link of this pivot has pushed may split on the stack.
        if (const auto place = freshOfLength(whole)) parent = &stack_[*place];
    }
    parent->length = split.activeLength;
    const std::uint32_t from = parent->lane;
    stack_.push_back({freeLane(), split.stackedLength, true});
    note(LaneChangeKind::Split, stack_.back().lane, from);
}

void LaneTracker::joinStacked(std::size_t gone, Ring& into) {
    const std::uint32_t lane = stack_[gone].lane;
    const std::uint32_t other = into.lane;
    stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(gone));
    releaseLane(lane);
    note(LaneChangeKind::Join, lane, other);
}

void LaneTracker::take(const JoinEvidence& join) {
    if (!active_ || stack_.empty()) return;
    if (join.depthFromTop == kNone) {
        const auto place = freshOfLength(join.length - active_->length);
        active_->length = join.length;
        joinStacked(place.value_or(stack_.size() - 1), *active_);
        return;
    }
    const std::size_t place =
        stack_.size() - 1 - std::min<std::size_t>(join.depthFromTop, stack_.size() - 1);
    if (active_->length + stack_[place].length != join.length) {
        const auto fresh = freshOfLength(join.length - stack_[place].length);
        if (fresh && *fresh != place) {
            // Two stacked rings: the longer one keeps its place.
            const bool keepFresh = stack_[*fresh].length >= stack_[place].length;
            const std::size_t kept = keepFresh ? *fresh : place;
            stack_[kept].length = join.length;
            joinStacked(keepFresh ? place : *fresh, stack_[kept]);
            return;
        }
    }
    active_->length = join.length;
    joinStacked(place, *active_);
}

void LaneTracker::take(const CloseEvidence& close) {
    closing_ = close.b == kNone ? 1U : 2U;
    if (const auto place = freshOfLength(closing_)) {
        const std::uint32_t lane = stack_[*place].lane;
        stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(*place));
        releaseLane(lane);
        note(LaneChangeKind::Closed, lane, lane);
    } else {
        endActive(LaneChangeKind::Closed);
    }
}

void LaneTracker::endActive(LaneChangeKind kind) {
    if (!active_) return;
    const std::uint32_t lane = active_->lane;
    active_.reset();
    releaseLane(lane);
    note(kind, lane, lane);
}

void LaneTracker::take(const FreeEvidence&) { endActive(LaneChangeKind::Freed); }

void LaneTracker::take(const AlertEvidence& alert) {
    if (alert.kind == AlertKind::TriangleCap || changes_.empty()) return;
    if (changes_.back().kind == LaneChangeKind::Freed) changes_.back().kind = LaneChangeKind::Hole;
}

void LaneTracker::activate(std::size_t place) {
    active_ = stack_[place];
    stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(place));
    note(LaneChangeKind::Activated, active_->lane, active_->lane);
}

void LaneTracker::take(const AdvanceEvidence& advance) {
    if (advance.popped && !active_ && !stack_.empty()) activate(stack_.size() - 1);
}

void LaneTracker::settle(const EdgeRings& rings) {
    if (rings.active() == kNone || active_ || stack_.empty()) return;
    // The pivot's ring was closed, and the traversal continues in one that it had split off.
    activate(freshOfLength(rings.length(rings.active())).value_or(stack_.size() - 1));
}

}  // namespace se
