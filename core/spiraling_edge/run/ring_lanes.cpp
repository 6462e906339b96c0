/// A replay of the ring stack from events. These carry lengths, not rings: where a split, join or
/// close may concern the active ring or one pushed by the same pivot, the length that fits decides,
/// and of equal ones the rings after the pivot. Freed lanes go to a heap, so that the least free
/// number is reused. O(1) per event, O(log lanes) per lane.
#include "spiraling_edge/run/ring_lanes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spiraling_edge/base/overloaded.h"

namespace se {

const char* laneChangeText(LaneChangeKind kind) {
    constexpr std::array<const char*, 8> kTexts{
        "seed",   "split off",          "comes off the stack",  "joined",
        "closed", "ends at a boundary", "ends at an open hole", "ends without a triangle"};
    static_assert(kTexts.size() == static_cast<std::size_t>(LaneChangeKind::Failed) + 1);
    return kTexts[static_cast<std::size_t>(kind)];
}

std::uint32_t lanesAt(std::span<const LaneChange> changes, std::uint32_t pivot) {
    const auto next = std::upper_bound(
        changes.begin(), changes.end(), pivot,
        [](std::uint32_t p, const LaneChange& change) { return p < change.pivot; });
    return next == changes.begin() ? 0 : std::prev(next)->live;
}

std::vector<LaneChange> LaneTracker::takeChanges() { return std::exchange(changes_, {}); }

void LaneTracker::begin(const EdgeRings& rings) {
    const auto add = [&](Index ring) {
        const Ring added{freeLane(), rings.length(ring), false, rings.number(ring)};
        numbered_ = std::max(numbered_, added.number + 1);
        ring == rings.active() ? void(active_ = added) : stack_.push_back(added);
        note(LaneChangeKind::Seed, added.lane, added.lane, added.number);
    };
    for (const Index ring : rings.stack()) add(ring);
    shelved_ = rings.shelved();
    if (rings.active() != kNone) add(rings.active());
}

void LaneTracker::take(const Event& event) {
    pivot_ = event.address.pivot;
    std::visit(
        Overloaded{[&](const SeedEvidence&) {
                       active_ = Ring{freeLane(), 2, false, numbered_++};
                       note(LaneChangeKind::Seed, active_->lane, active_->lane, active_->number);
                   },
                   [&](const PivotEvidence& pivot) { beginPivot(pivot.ringLength); },
                   [&](const FillEvidence& fill) { beginPivot(fill.ringLength); },
                   [&](const InsertEvidence& insert) {
                       const bool inserted =
                           insert.verdict == Verdict::Before || insert.verdict == Verdict::After;
                       if (active_ && inserted) ++active_->length;
                   },
                   [&](const RingEvidence& ring) { changeLength(ring.inserted); },
                   [&](const SplitEvidence& split) { splitRing(split); },
                   [&](const JoinEvidence& join) { joinRings(join); },
                   [&](const CloseEvidence& close) {
                       if (close.rest > 0) return shorten(close);
                       closeRing(close.b == kNone ? 1 : 2);
                   },
                   [&](const AdvanceEvidence& advance) {
                       if (advance.popped) pop();
                   },
                   [&](const ShelveEvidence&) { shelveActive(); },
                   [&](const TakeUpEvidence&) {
                       shelved_ = 0;
                       if (!active_ && !stack_.empty()) activate(stack_.size() - 1);
                   },
                   [&](const FreeEvidence& free) {
                       endActive(free.seed ? LaneChangeKind::Failed : LaneChangeKind::Freed);
                   },
                   [&](const AlertEvidence& alert) {
                       const bool freed =
                           !changes_.empty() && changes_.back().kind == LaneChangeKind::Freed;
                       if (freed && alert.kind != AlertKind::TriangleCap)
                           changes_.back().kind = LaneChangeKind::Hole;
                   },
                   [](const auto&) {}},
        event.evidence);
}

void LaneTracker::note(LaneChangeKind kind, std::uint32_t lane, std::uint32_t other, Index ring) {
    changes_.push_back({pivot_, lane, other, live(), kind, ring});
}

std::uint32_t LaneTracker::freeLane() {
    if (free_.empty()) return lanes_++;
    const std::uint32_t lane = free_.top();
    free_.pop();
    return lane;
}

void LaneTracker::endLane(LaneChangeKind kind, std::uint32_t lane, std::uint32_t other) {
    free_.push(lane);
    note(kind, lane, other);
}

void LaneTracker::beginPivot(Index ringLength) {
    if (active_) active_->length = ringLength;
    for (auto ring = stack_.rbegin(); ring != stack_.rend() && ring->fresh; ++ring) {
        ring->fresh = false;
    }
    closing_ = 0;
}

void LaneTracker::changeLength(bool inserted) {
    if (closing_ > 0) {
        --closing_;
    } else if (active_) {
        active_->length += inserted ? 1U : Index(-1);
    }
}

std::optional<std::size_t> LaneTracker::freshOfLength(Index length) const {
    for (std::size_t i = stack_.size(); i-- > 0 && stack_[i].fresh;) {
        if (stack_[i].length == length) return i;
    }
    return std::nullopt;
}

LaneTracker::Ring LaneTracker::unstack(std::size_t place) {
    const Ring ring = stack_[place];
    stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(place));
    if (place < shelved_) --shelved_;
    return ring;
}

void LaneTracker::splitRing(const SplitEvidence& split) {
    if (!active_) return;
    const Index whole = split.activeLength + split.stackedLength;
    Ring* parent = &*active_;
    if (active_->length != whole) {
        // A ring that an earlier link of this pivot has pushed may split on the stack.
        if (const auto place = freshOfLength(whole)) parent = &stack_[*place];
    }
    parent->length = split.activeLength;
    const std::uint32_t from = parent->lane;
    stack_.push_back({freeLane(), split.stackedLength, true, numbered_++});
    note(LaneChangeKind::Split, stack_.back().lane, from, stack_.back().number);
}

void LaneTracker::joinRings(const JoinEvidence& join) {
    if (!active_ || stack_.empty()) return;
    const std::size_t top = stack_.size() - 1;
    Ring* kept = &*active_;
    std::size_t gone = 0;
    if (join.depthFromTop == kNone) {
        gone = freshOfLength(join.length - active_->length).value_or(top);
    } else {
        gone = top - std::min<std::size_t>(join.depthFromTop, top);
        const auto fresh = freshOfLength(join.length - stack_[gone].length);
        if (active_->length + stack_[gone].length != join.length && fresh && *fresh != gone) {
            // Two stacked rings: the longer one keeps its place.
            const bool keepFresh = stack_[*fresh].length >= stack_[gone].length;
            kept = &stack_[keepFresh ? *fresh : gone];
            if (!keepFresh) gone = *fresh;
        }
    }
    kept->length = join.length;
    const std::uint32_t into = kept->lane;
    endLane(LaneChangeKind::Join, unstack(gone).lane, into);
}

void LaneTracker::closeRing(Index entries) {
    closing_ = entries;
    if (const auto place = freshOfLength(entries)) {
        const std::uint32_t lane = unstack(*place).lane;
        endLane(LaneChangeKind::Closed, lane, lane);
    } else {
        endActive(LaneChangeKind::Closed);
    }
}

void LaneTracker::shorten(const CloseEvidence& close) {
    closing_ = 2;
    if (close.depthFromTop == kNone) {
        if (active_) active_->length = close.rest;
    } else if (close.depthFromTop < stack_.size()) {
        stack_[stack_.size() - 1 - close.depthFromTop].length = close.rest;
    }
}

void LaneTracker::endActive(LaneChangeKind kind) {
    if (!active_) return;
    const std::uint32_t lane = active_->lane;
    active_.reset();
    endLane(kind, lane, lane);
}

void LaneTracker::shelveActive() {
    if (!active_) return;
    stack_.insert(stack_.begin() + static_cast<std::ptrdiff_t>(shelved_++), *active_);
    active_.reset();
}

void LaneTracker::pop() {
    if (active_ || stack_.size() <= shelved_) return;
    activate(rule_ == StackRule::First ? shelved_ : stack_.size() - 1);
}

void LaneTracker::activate(std::size_t place) {
    active_ = unstack(place);
    note(LaneChangeKind::Activated, active_->lane, active_->lane);
}

void LaneTracker::settle(const EdgeRings& rings) {
    if (rings.active() == kNone) return;
    if (!active_) {
        if (stack_.empty()) return;
        // The pivot's ring was closed, and the traversal continues in one that it had split off.
        std::size_t place = stack_.size() - 1;
        const Index meant = rings.number(rings.active());
        while (stack_[place].number != meant && place > 0 && stack_[place - 1].fresh) --place;
        activate(place);
    }
    // Where two rings were equally long, the wrong one may have been split.
    active_->length = rings.length(rings.active());
    if (stack_.size() != rings.stack().size()) return;
    for (std::size_t i = stack_.size(); i-- > 0 && stack_[i].fresh;)
        stack_[i].length = rings.length(rings.stack()[i]);
}

}  // namespace se
