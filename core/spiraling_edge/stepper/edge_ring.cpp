/// Doubly linked rings in a pool, with free lists and a chain of entries per point. Split and join
/// are one exchange of successors; relabeling after a split walks both parts in step, so that it
/// costs the length of the shorter one, and after a join that of the shorter ring.
#include "spiraling_edge/stepper/edge_ring.h"

#include <cassert>
#include <utility>

namespace se {

Index EdgeRings::depthFromTop(Index ring) const {
    const Index position = rings_[ring].stackPosition;
    if (position == kNone) return kNone;
    return static_cast<Index>(stack_.size()) - 1 - position;
}

bool EdgeRings::isFoundBefore(Index a, Index b) const {
    const auto rank = [&](Index entry) {
        const Index ring = ringOf(entry);
        return ring == active_ ? 0 : depthFromTop(ring) + 1;
    };
    return rank(a) < rank(b);
}

Index EdgeRings::firstInstance(Index point, Index from) const {
    const auto isMetBefore = [&](Index a, Index b) {
        const Index ring = ringOf(a);
        Index e = from != kNone && ringOf(from) == ring ? from : head(ring);
        while (e != a && e != b) e = next(e);
        return e == a;
    };
    Index found = kNone;
    for (Index e = firstEntryOf(point); e != kNone; e = entries_[e].nextOfPoint) {
        if (e == from) continue;
        const bool first = found == kNone || isFoundBefore(e, found) ||
                           (ringOf(e) == ringOf(found) && isMetBefore(e, found));
        if (first) found = e;
    }
    return found;
}

Index EdgeRings::newRing() {
    auto ring = static_cast<Index>(rings_.size());
    if (freeRings_.empty()) {
        rings_.emplace_back();
    } else {
        ring = freeRings_.back();
        freeRings_.pop_back();
        rings_[ring] = Ring{};
    }
    rings_[ring].number = numbered_++;
    return ring;
}

void EdgeRings::numberSplit(Index fresh, Index other) {
    if (rings_[fresh].number < rings_[other].number)
        std::swap(rings_[fresh].number, rings_[other].number);
}

void EdgeRings::freeRing(Index ring) {
    if (active_ == ring) active_ = kNone;
    removeFromStack(ring);
    rings_[ring] = Ring{};
    freeRings_.push_back(ring);
}

void EdgeRings::removeFromStack(Index ring) {
    const Index position = rings_[ring].stackPosition;
    if (position == kNone) return;
    stack_.erase(stack_.begin() + position);
    if (position < shelved_) --shelved_;
    numberStack(position);
    rings_[ring].stackPosition = kNone;
}

void EdgeRings::numberStack(std::size_t from) {
    for (std::size_t i = from; i < stack_.size(); ++i)
        rings_[stack_[i]].stackPosition = static_cast<Index>(i);
}

Index EdgeRings::newEntry(Index point, Index ring) {
    Index entry = freeEntry_;
    if (entry == kNone) {
        entry = static_cast<Index>(entries_.size());
        entries_.emplace_back();
    } else {
        freeEntry_ = entries_[entry].next;
    }
    entries_[entry] = {point, kNone, kNone, ring, headOfPoint_[point], false};
    headOfPoint_[point] = entry;
    ++rings_[ring].length;
    return entry;
}

void EdgeRings::unchain(Index entry) {
    Index* link = &headOfPoint_[entries_[entry].point];
    while (*link != entry) link = &entries_[*link].nextOfPoint;
    *link = entries_[entry].nextOfPoint;
}

Index EdgeRings::start(Index p, Index q) {
    assert(active_ == kNone);
    const Index ring = newRing();
    const Index a = newEntry(p, ring);
    const Index b = newEntry(q, ring);
    entries_[a].next = entries_[a].prev = b;
    entries_[b].next = entries_[b].prev = a;
    entries_[a].open = entries_[b].open = true;
    rings_[ring].head = a;
    active_ = ring;
    return a;
}

Index EdgeRings::insertAfter(Index entry, Index point) {
    assert(alive(entry));
    const Index made = newEntry(point, entries_[entry].ring);
    const Index next = entries_[entry].next;
    entries_[made].prev = entry;
    entries_[made].next = next;
    entries_[made].open = entries_[entry].open;
    entries_[entry].next = made;
    entries_[next].prev = made;
    return made;
}

void EdgeRings::erase(Index entry) {
    assert(alive(entry));
    RingEntry& e = entries_[entry];
    const Index ring = e.ring;
    entries_[e.prev].next = e.next;
    entries_[e.next].prev = e.prev;
    if (rings_[ring].head == entry) rings_[ring].head = e.next;
    unchain(entry);
    if (--rings_[ring].length == 0) freeRing(ring);
    e = RingEntry{};
    e.next = freeEntry_;
    freeEntry_ = entry;
}

void EdgeRings::relabel(Index from, Index to, Index ring) {
    for (Index entry = from;; entry = entries_[entry].next) {
        entries_[entry].ring = ring;
        if (entry == to) return;
    }
}

Exchange EdgeRings::exchangeSuccessors(Index x, Index y) {
    assert(alive(x) && alive(y) && x != y);
    const Index ringX = entries_[x].ring;
    const Index ringY = entries_[y].ring;
    std::swap(entries_[x].next, entries_[y].next);
    std::swap(entries_[x].open, entries_[y].open);
    entries_[entries_[x].next].prev = x;
    entries_[entries_[y].next].prev = y;
    return ringX == ringY ? finishSplit(x, y) : finishJoin(x, y, ringX, ringY);
}

Exchange EdgeRings::finishSplit(Index x, Index y) {
    const Index old = entries_[x].ring;
    // Walk both parts in step until the shorter one closes, and relabel only that one.
    Index a = x;
    Index b = y;
    Index length = 0;
    do {
        a = entries_[a].next;
        b = entries_[b].next;
        ++length;
    } while (a != x && b != y);
    const Index inShorter = a == x ? x : y;
    const Index made = newRing();
    relabel(entries_[inShorter].next, inShorter, made);
    rings_[made].length = length;
    rings_[made].head = inShorter;
    assert(rings_[old].length > length);  // Both parts have entries.
    rings_[old].length -= length;
    rings_[old].head = inShorter == x ? y : x;
    return {true, entries_[x].ring, entries_[y].ring};
}

Exchange EdgeRings::finishJoin(Index x, Index y, Index ringX, Index ringY) {
    // The entries of ring y now run from x's successor to y, those of ring x from y's successor to
    // x.
    const bool keepX = rings_[ringX].length >= rings_[ringY].length;
    const Index kept = keepX ? ringX : ringY;
    const Index gone = keepX ? ringY : ringX;
    if (keepX) {
        relabel(entries_[x].next, y, kept);
    } else {
        relabel(entries_[y].next, x, kept);
    }
    rings_[kept].length += rings_[gone].length;
    const bool becomesActive = active_ == gone;
    if (becomesActive) rings_[kept].number = rings_[gone].number;
    freeRing(gone);
    if (becomesActive) activate(kept);
    return {false, kept, kept};
}

Index EdgeRings::activate(Index ring) {
    assert(length(ring) > 0);
    removeFromStack(ring);
    active_ = ring;
    return rings_[ring].head;
}

void EdgeRings::push(Index ring, Index head) {
    assert(alive(head) && ringOf(head) == ring);
    removeFromStack(ring);
    if (active_ == ring) active_ = kNone;
    rings_[ring].head = head;
    rings_[ring].stackPosition = static_cast<Index>(stack_.size());
    stack_.push_back(ring);
}

void EdgeRings::shelve(Index head) {
    assert(active_ != kNone && ringOf(head) == active_);
    rings_[active_].head = head;
    stack_.insert(stack_.begin() + shelved_, active_);
    numberStack(shelved_);
    ++shelved_;
    active_ = kNone;
}

EdgeRings EdgeRings::withoutPoints() const {
    EdgeRings copy;
    copy.entries_ = entries_;
    copy.rings_ = rings_;
    copy.stack_ = stack_;
    copy.shelved_ = shelved_;
    copy.freeRings_ = freeRings_;
    copy.freeEntry_ = freeEntry_;
    copy.active_ = active_;
    copy.numbered_ = numbered_;
    return copy;
}

void EdgeRings::restore(const EdgeRings& rings) {
    for (const RingEntry& e : entries_) {
        if (e.ring != kNone) headOfPoint_[e.point] = kNone;
    }
    std::vector<Index> heads = std::move(headOfPoint_);
    *this = rings;
    headOfPoint_ = std::move(heads);
    // The head of a point's chain is the entry that no other links to.
    std::vector<bool> later(entries_.size(), false);
    for (const RingEntry& e : entries_) {
        if (e.ring != kNone && e.nextOfPoint != kNone) later[e.nextOfPoint] = true;
    }
    for (Index entry = 0; entry < entries_.size(); ++entry) {
        if (entries_[entry].ring != kNone && !later[entry]) {
            headOfPoint_[entries_[entry].point] = entry;
        }
    }
}

std::size_t EdgeRings::bytesWithoutPoints() const {
    return sizeof(EdgeRings) + entries_.size() * sizeof(RingEntry) + rings_.size() * sizeof(Ring) +
           (stack_.size() + freeRings_.size()) * sizeof(Index);
}

Index EdgeRings::pop() { return stack_.size() == shelved_ ? kNone : activate(stack_.back()); }

Index EdgeRings::popOldest() {
    return stack_.size() == shelved_ ? kNone : activate(stack_[shelved_]);
}

}  // namespace se
