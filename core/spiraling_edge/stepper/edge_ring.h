/// The edge rings of §4 and §6.5: the active ring and the stack of the others.
///
/// Invariants (checked by checkInvariants() in invariants.h):
///  1. next and prev agree; each live entry is in exactly one ring; ring lengths are right.
///  2. A point's chain holds exactly its live entries.
///  3. The active ring is not on the stack; no ring is on the stack twice.
#pragma once

#include <cstddef>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// One place on a ring. Its step is the edge from its point to the point of `next`. A point may
/// have several entries, also in one ring (§4). Dead entries have ring == kNone.
struct RingEntry {
    Index point = kNone;
    Index prev = kNone;
    Index next = kNone;
    Index ring = kNone;
    Index nextOfPoint = kNone;  ///< Next entry of the same point, newest first.
    bool open = false;          ///< The step to `next` is not an edge of the mesh.
};

/// The result of EdgeRings::exchangeSuccessors().
struct Exchange {
    bool split = false;     ///< One ring became two; else two became one.
    Index ringOfX = kNone;  ///< Ring of x afterwards.
    Index ringOfY = kNone;  ///< Ring of y afterwards; equal to ringOfX after a join.
};

class EdgeRings;

/// The entries of one ring, as a range.
class RingEntries {
  public:
    class Iterator {
      public:
        // NOLINTBEGIN(readability-identifier-naming): names of the standard library
        using value_type = Index;
        using difference_type = std::ptrdiff_t;
        // NOLINTEND(readability-identifier-naming)
        Iterator() = default;
        Iterator(const EdgeRings& rings, Index entry, Index place)
            : rings_(&rings), entry_(entry), place_(place) {}
        Index operator*() const { return entry_; }
        inline Iterator& operator++();
        Iterator operator++(int) {
            const Iterator here = *this;
            ++*this;
            return here;
        }
        friend bool operator==(const Iterator& a, const Iterator& b) {
            return a.place_ == b.place_;
        }

      private:
        const EdgeRings* rings_ = nullptr;
        Index entry_ = kNone;
        Index place_ = 0;
    };

    RingEntries(const EdgeRings& rings, Index head, Index length)
        : rings_(&rings), head_(head), length_(length) {}
    Iterator begin() const { return {*rings_, head_, 0}; }
    Iterator end() const { return {*rings_, head_, length_}; }

  private:
    const EdgeRings* rings_;
    Index head_;
    Index length_;
};

/// Pooled doubly linked rings with a stack. Entries and rings are named by index, so the rings as a
/// whole are a plain value that can be copied. No call allocates once the pool has grown to its
/// working size.
class EdgeRings {
  public:
    EdgeRings() = default;
    explicit EdgeRings(std::size_t pointCount) : headOfPoint_(pointCount, kNone) {}

    // Queries.
    const RingEntry& operator[](Index entry) const { return entries_[entry]; }
    Index point(Index entry) const { return entries_[entry].point; }
    Index next(Index entry) const { return entries_[entry].next; }
    Index prev(Index entry) const { return entries_[entry].prev; }
    Index ringOf(Index entry) const { return entries_[entry].ring; }
    bool alive(Index entry) const { return entry != kNone && entries_[entry].ring != kNone; }
    /// True if the step from `entry` to its successor is not an edge of the mesh.
    bool open(Index entry) const { return entries_[entry].open; }
    /// Newest entry of a point, kNone if it is in no ring. Continue with nextOfPoint.
    Index firstEntryOf(Index point) const { return headOfPoint_[point]; }
    /// Number of entries of a ring.
    Index length(Index ring) const { return rings_[ring].length; }
    /// An entry of the ring to start walking at; for a stacked ring, the pivot when it is popped.
    Index head(Index ring) const { return rings_[ring].head; }
    /// The entries of a ring, from its head on: `for (Index entry : rings.entriesOf(ring))`. Valid
    /// until the rings change.
    RingEntries entriesOf(Index ring) const { return {*this, head(ring), length(ring)}; }
    /// The number of a ring among all of the run, from 0: the part of a split that goes on keeps
    /// it, as does the ring that another one joins. Never given twice.
    Index number(Index ring) const { return rings_[ring].number; }
    /// The active ring, kNone if there is none.
    Index active() const { return active_; }
    /// Stacked rings, the most recently pushed last.
    const std::vector<Index>& stack() const { return stack_; }
    /// The number of rings at the bottom of the stack that are shelved: pop() leaves them there.
    Index shelved() const { return shelved_; }
    /// Place of a ring on the stack counted from the top (0 = top), kNone if it is not on it.
    Index depthFromTop(Index ring) const;
    /// True if the search of §6.5 comes to the ring of entry a before that of b: the active ring
    /// first, then the stack from the top. False if they are on one ring.
    bool isFoundBefore(Index a, Index b) const;
    /// §6.5: the first entry of a point but `from` in that search, kNone if there is none. Within a
    /// ring, Choice: along it, from the entry `from` on if that is on it, else from its head.
    /// O(ring) where a ring has several entries of the point.
    Index firstInstance(Index point, Index from) const;
    std::size_t pointCount() const { return headOfPoint_.size(); }
    std::size_t entryCapacity() const { return entries_.size(); }
    std::size_t ringCapacity() const { return rings_.size(); }

    // Modifiers.
    /// Makes p, q the active ring, both steps open. Requires no active ring. Returns p's entry.
    Index start(Index p, Index q);
    /// Inserts a new entry after `entry`; the new entry's step takes over the open mark of `entry`.
    Index insertAfter(Index entry, Index point);
    void setOpen(Index entry, bool open) { entries_[entry].open = open; }
    /// Removes an entry; its predecessor's step then leads to its successor. A ring that loses its
    /// last entry is removed, also from the stack or as active ring.
    void erase(Index entry);
    /// The one operation of split and join (§6.5, Fig. 12): x and y swap their successors, together
    /// with the open marks of those steps. Of a split, one part keeps the ring's role (active, or
    /// its place on the stack); the other has none until activate() or push() gives it one. A
    /// joined ring is active if either was, and leaves the stack then.
    Exchange exchangeSuccessors(Index x, Index y);
    /// Makes `ring` the active one; takes it off the stack if it was there.
    /// The ring that was active is neither afterwards. Returns the head.
    Index activate(Index ring);
    /// Of the two parts of a split, `fresh` gets the new number, and the other keeps the old one.
    void numberSplit(Index fresh, Index other);
    /// Puts a ring on top of the stack; `head` is where its traversal will begin.
    void push(Index ring, Index head);
    /// Puts the active ring on the shelf, on top of the rings that are shelved; `head` is where its
    /// traversal will begin.
    void shelve(Index head);
    /// Makes the shelved rings ordinary ones of the stack.
    void unshelve() { shelved_ = 0; }
    /// Makes the top of the stack the active ring and returns its head; kNone if the stack is
    /// empty but for shelved rings.
    Index pop();
    /// As pop(), with the ring pushed first.
    Index popOldest();

    // Keyframes.
    /// A copy of the rings without the entry chains of the points, which follow from the entries:
    /// its size is proportional to the length of the rings, not to the number of points.
    EdgeRings withoutPoints() const;
    /// Restores the rings that `rings` was made of by withoutPoints(). Touches only points that
    /// have entries before or after it.
    void restore(const EdgeRings& rings);
    /// Approximate size of withoutPoints(), in bytes.
    std::size_t bytesWithoutPoints() const;

  private:
    struct Ring {
        Index head = kNone;
        Index length = 0;
        Index stackPosition = kNone;
        Index number = 0;
    };

    Index newEntry(Index point, Index ring);
    Index newRing();
    void freeRing(Index ring);
    void removeFromStack(Index ring);
    /// Renews the positions of the rings on the stack from this one on.
    void numberStack(std::size_t from);
    /// Assigns the entries from `from` to `to`, both included, to `ring`.
    void relabel(Index from, Index to, Index ring);
    Exchange finishSplit(Index x, Index y);
    Exchange finishJoin(Index x, Index y, Index ringX, Index ringY);
    void unchain(Index entry);

    std::vector<RingEntry> entries_;
    std::vector<Index> headOfPoint_;
    std::vector<Ring> rings_;
    std::vector<Index> stack_;
    Index shelved_ = 0;
    std::vector<Index> freeRings_;
    Index freeEntry_ = kNone;
    Index active_ = kNone;
    Index numbered_ = 0;  ///< Rings made so far.
};

RingEntries::Iterator& RingEntries::Iterator::operator++() {
    entry_ = rings_->next(entry_);
    ++place_;
    return *this;
}

}  // namespace se
