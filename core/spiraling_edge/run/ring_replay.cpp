// The rings within a pivot are rebuilt from its events on a copy of the rings before it, with the
// same EdgeRings operations as in the stepper, so that every sub-step can be shown although a
// record stores only the rings at the pivot's ends. Events name points, not entries: the pivot's
// entry is found by its two ring neighbors, and further instances of a point in the order in which
// the stepper tests them.
#include "spiraling_edge/run/ring_replay.h"

#include <algorithm>

#include "spiraling_edge/stepper/verdict_table.h"

namespace se {

RingReplay::RingReplay(const EdgeRings& before, std::size_t pointCount, const PaperRules& rules)
    : rings_(pointCount), rules_(rules) {
    rings_.restore(before);
}

void RingReplay::apply(const Event& event) {
    if (lost_) return;
    stage_ = event.address.stage;
    std::visit([this](const auto& evidence) { on(evidence); }, event.evidence);
}

std::vector<Index> RingReplay::entriesOf(Index ring) const {
    std::vector<Index> entries;
    if (ring == kNone) return entries;
    for (const Index entry : rings_.entriesOf(ring)) entries.push_back(entry);
    return entries;
}

void RingReplay::on(const SeedEvidence& e) { rings_.start(e.first, e.second); }

void RingReplay::takePivot(Index pivot, Index first, Index last) {
    const std::vector<Index> entries = entriesOf(rings_.active());
    const auto found = std::find_if(entries.begin(), entries.end(), [&](Index e) {
        return rings_.point(e) == pivot && rings_.point(rings_.prev(e)) == first &&
               rings_.point(rings_.next(e)) == last;
    });
    lost_ = found == entries.end();
    if (lost_) return;
    pivot_ = *found;
    start_ = rings_.prev(pivot_);
    end_ = rings_.next(pivot_);
}

void RingReplay::on(const InsertEvidence& e) {
    const bool before = e.verdict == Verdict::Before;
    if (!before && e.verdict != Verdict::After) return;
    // Neither of its steps is an edge of the mesh.
    const Index previous = before ? rings_.prev(pivot_) : pivot_;
    const Index third = rings_.insertAfter(previous, e.third);
    rings_.setOpen(previous, true);
    rings_.setOpen(third, true);
    start_ = rings_.prev(pivot_);
    end_ = rings_.next(pivot_);
}

void RingReplay::on(const LimitEvidence& e) {
    if (!e.moves()) return;
    const bool start = e.side == Side::Start;
    Index& limit = start ? start_ : end_;
    limit = start ? rings_.prev(limit) : rings_.next(limit);
}

void RingReplay::on(const ReciprocalEvidence& e) {
    // One test for each entry of the candidate.
    const bool another = tested_ != kNone && rings_.point(tested_) == e.point;
    tested_ = another ? rings_[tested_].nextOfPoint : rings_.firstEntryOf(e.point);
    lost_ = tested_ == kNone;
    if (lost_ || !isTaken(e.verdict)) return;
    const Instance found{tested_, isWhatIf(e.verdict)};
    const auto [known, fresh] = instances_.try_emplace(e.point, found);
    Instance& best = known->second;
    // A what-if takes one of those that do not hold the pivot only if there is no other.
    const bool better =
        found.whatIf == best.whatIf ? rings_.isFoundBefore(found.entry, best.entry) : best.whatIf;
    if (!fresh && better) best = found;
}

void RingReplay::beginUpdate() {
    updating_ = true;
    leaving_.push_back(pivot_);
    for (Index e = rings_.prev(pivot_); e != start_; e = rings_.prev(e)) leaving_.push_back(e);
    for (Index e = rings_.next(pivot_); e != end_; e = rings_.next(e)) leaving_.push_back(e);
    std::reverse(leaving_.begin(), leaving_.end());
}

void RingReplay::on(const RingEvidence& e) {
    // A freed ring loses its entries one after the other, from its head on.
    if (stage_ == Stage::Done && rings_.active() != kNone) {
        leaving_ = {rings_.head(rings_.active())};
    } else if (!updating_ && pivot_ != kNone) {
        beginUpdate();
    }
    if (e.inserted) {
        const Index previous = inserted_.empty() ? start_ : inserted_.back();
        inserted_.push_back(rings_.insertAfter(previous, e.point));
        // A point that no sector was found for, or none was looked for, is linked to its first one.
        const bool first = rules_.instance == InstanceRule::First || !instances_.contains(e.point);
        if (first && e.status > 1)
            instances_[e.point] = {rings_.firstInstance(e.point, inserted_.back())};
        return;
    }
    lost_ = leaving_.empty() || rings_.point(leaving_.back()) != e.point;
    if (lost_) return;
    rings_.erase(leaving_.back());
    leaving_.pop_back();
    // From start to end the ring now follows the rim of the new fan.
    if (leaving_.empty() && rings_.alive(start_) && linked_ == 0 && !finished_)
        rings_.setOpen(start_, false);
}

bool RingReplay::nextLink(Index point) {
    for (; linked_ < inserted_.size(); ++linked_) {
        x_ = inserted_[linked_];
        if (!rings_.alive(x_)) continue;
        const auto other = instances_.find(rings_.point(x_));
        const bool seeks = rules_.instance == InstanceRule::First;
        if (other == instances_.end()) continue;
        if (seeks) other->second.entry = rings_.firstInstance(rings_.point(x_), x_);
        if (!rings_.alive(other->second.entry)) continue;
        y_ = other->second.entry;
        ++linked_;
        return rings_.point(x_) == point;
    }
    return false;
}

Index RingReplay::nextEntry() const {
    if (rules_.next == NextRule::Start && rings_.alive(start_)) return start_;
    if (rings_.alive(end_)) return end_;
    const auto left = std::find_if(inserted_.rbegin(), inserted_.rend(),
                                   [&](Index e) { return rings_.alive(e); });
    if (left != inserted_.rend()) return *left;
    return rings_.alive(start_) ? start_ : kNone;
}

/// One part stays active, by its length; of equal ones that which holds end, or the other one
/// (PaperRules::active). The other part goes on the stack.
void RingReplay::place(const Exchange& made, Index activeLength) {
    const bool wasActive = made.ringOfX == rings_.active() || made.ringOfY == rings_.active();
    bool pushX = rings_.depthFromTop(made.ringOfX) == kNone;
    if (wasActive) {
        const Index on = nextEntry();
        const Index x = rings_.length(made.ringOfX);
        const bool endIsElsewhere = on == kNone || rings_.ringOf(on) != made.ringOfX;
        pushX = x == rings_.length(made.ringOfY)
                    ? endIsElsewhere != (rules_.active == ActiveRule::Other)
                    : x != activeLength;
        rings_.activate(pushX ? made.ringOfY : made.ringOfX);
    }
    const Index pushed = pushX ? made.ringOfX : made.ringOfY;
    const Index kept = pushX ? made.ringOfY : made.ringOfX;
    rings_.numberSplit(pushed, kept);
    rings_.push(pushed, pushX ? x_ : y_);
    exchange_ = {ringPath(rings_, kept), ringPath(rings_, pushed)};
}

void RingReplay::on(const SplitEvidence& e) {
    lost_ = !nextLink(e.point) || rings_.ringOf(x_) != rings_.ringOf(y_);
    if (lost_) return;
    place(rings_.exchangeSuccessors(x_, y_), e.activeLength);
}

void RingReplay::on(const JoinEvidence& e) {
    lost_ = !nextLink(e.point) || rings_.ringOf(x_) == rings_.ringOf(y_);
    if (lost_) return;
    exchange_ = {ringPath(rings_, rings_.ringOf(x_)), ringPath(rings_, rings_.ringOf(y_))};
    rings_.exchangeSuccessors(x_, y_);
}

void RingReplay::closeWithin(const CloseEvidence& e) {
    const std::vector<Index>& stack = rings_.stack();
    lost_ = e.depthFromTop != kNone && e.depthFromTop >= stack.size();
    if (lost_) return;
    const Index ring =
        e.depthFromTop == kNone ? rings_.active() : stack[stack.size() - 1 - e.depthFromTop];
    const std::vector<Index> entries = entriesOf(ring);
    const auto found = std::find_if(entries.begin(), entries.end(), [&](Index entry) {
        return rings_.point(entry) == e.a && rings_.point(rings_.prev(entry)) == e.b &&
               rings_.point(rings_.next(entry)) == e.b;
    });
    lost_ = found == entries.end() || entries.size() != e.rest + 2;
    if (lost_) return;
    const Index before = rings_.prev(*found);
    const Index after = rings_.next(*found);
    rings_.setOpen(before, rings_.open(after));
    if (end_ == *found || end_ == after) end_ = rings_.next(after);
    if (start_ == *found || start_ == after) start_ = before;
    leaving_ = {after, *found};
    x_ = before;       // Its ring may close next.
    finished_ = true;  // The step after start is final.
}

void RingReplay::on(const CloseEvidence& e) {
    if (e.rest > 0) return closeWithin(e);
    const auto isMeant = [&](Index ring) {
        if (ring == kNone || rings_.length(ring) != (e.b == kNone ? 1U : 2U)) return false;
        const Index head = rings_.head(ring);
        return rings_.point(head) == e.a &&
               (e.b == kNone || rings_.point(rings_.next(head)) == e.b);
    };
    const auto ringOf = [&](Index entry) {
        return rings_.alive(entry) ? rings_.ringOf(entry) : kNone;
    };
    for (const Index ring : {ringOf(x_), ringOf(y_), rings_.active()}) {
        if (!isMeant(ring)) continue;
        const Index head = rings_.head(ring);
        leaving_ = {head};
        if (e.b != kNone) leaving_ = {rings_.next(head), head};
        return;
    }
    lost_ = true;
}

void RingReplay::on(const ShelveEvidence&) {
    lost_ = !rings_.alive(pivot_) || rings_.ringOf(pivot_) != rings_.active();
    if (!lost_) rings_.shelve(rings_.next(pivot_));
}

void RingReplay::on(const TakeUpEvidence&) {
    rings_.unshelve();
    rings_.pop();
}

}  // namespace se
