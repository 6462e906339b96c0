/// One lane per edge ring, over the whole run: splits fork, joins merge, closed and freed rings
/// end. Derived from the events of the run; the lanes at any time are the active ring and the
/// stack.
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "spiraling_edge/stepper/edge_ring.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// Kind of change of a lane.
enum class LaneChangeKind : std::uint8_t {
    Seed,       ///< Begins, with a ring of two, or as a ring of a given start.
    Split,      ///< Begins, split off the lane `other`.
    Activated,  ///< Comes off the stack.
    Join,       ///< Ends in the lane `other`.
    Closed,     ///< Ends: its last gap is filled.
    Freed,      ///< Ends: the surface ends here (a boundary).
    Hole,       ///< Ends: a hole stays open, or the seed got no triangle. There is an alert.
    Failed,     ///< Ends: a seed without a triangle, whose points are UNUSED again.
};
/// "split off", "closed", ...
const char* laneChangeText(LaneChangeKind kind);
inline bool beginsLane(LaneChangeKind kind) { return kind <= LaneChangeKind::Split; }

/// One change of a lane.
struct LaneChange {
    std::uint32_t pivot = 0;
    std::uint32_t lane = 0;   ///< From 0; lanes are reused.
    std::uint32_t other = 0;  ///< Of a split or join.
    std::uint32_t live = 0;   ///< Lanes afterwards.
    LaneChangeKind kind = LaneChangeKind::Seed;
    Index ring = 0;  ///< The number of the ring that begins, as EdgeRings::number().
};

/// Lanes after the given number of pivots; `changes` are in the order of the run.
std::uint32_t lanesAt(std::span<const LaneChange> changes, std::uint32_t pivot);

/// Gives every ring of a run its lane.
///
/// Events name no rings. The stack is replayed from them, and where an event could mean one of
/// several rings their lengths decide.
class LaneTracker {
  public:
    struct Ring {
        std::uint32_t lane = 0;
        Index length = 0;
        bool fresh = false;  ///< Pushed by the current pivot.
        Index number = 0;    ///< As EdgeRings::number().
    };

    /// `rule`: that of the run (PaperRules::stack).
    explicit LaneTracker(StackRule rule = StackRule::Last) : rule_(rule) {}

    /// Gives the rings of a given start their lanes. Call it before the first event.
    void begin(const EdgeRings& rings);
    /// Takes the next event of the run.
    void take(const Event& event);
    /// Corrects the active ring and lengths from the rings, for changes without an event, and where
    /// an event fits several rings. Call between two pivots.
    void settle(const EdgeRings& rings);

    const std::optional<Ring>& active() const { return active_; }
    /// The most recently pushed last.
    const std::vector<Ring>& stack() const { return stack_; }
    std::uint32_t live() const {
        return static_cast<std::uint32_t>(stack_.size()) + (active_ ? 1U : 0U);
    }
    /// The changes since the last call.
    std::vector<LaneChange> takeChanges();

  private:
    void beginPivot(Index ringLength);
    void changeLength(bool inserted);
    void splitRing(const SplitEvidence& split);
    void joinRings(const JoinEvidence& join);
    void closeRing(Index entries);
    /// Two entries leave a longer ring.
    void shorten(const CloseEvidence& close);
    /// Position on the stack of the ring of that length pushed by the current pivot.
    std::optional<std::size_t> freshOfLength(Index length) const;
    /// Removes a ring from the stack.
    Ring unstack(std::size_t place);
    void activate(std::size_t place);
    /// Activates the ring that the rule takes off the stack.
    void pop();
    /// Puts the active ring above the shelved ones.
    void shelveActive();
    void endActive(LaneChangeKind kind);
    void endLane(LaneChangeKind kind, std::uint32_t lane, std::uint32_t other);
    void note(LaneChangeKind kind, std::uint32_t lane, std::uint32_t other, Index ring = 0);
    std::uint32_t freeLane();

    StackRule rule_;
    std::optional<Ring> active_;
    std::vector<Ring> stack_;
    std::size_t shelved_ = 0;  ///< Number of rings at the bottom of the stack that are shelved.
    std::vector<LaneChange> changes_;
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_;
    std::uint32_t lanes_ = 0;
    Index numbered_ = 0;  ///< Rings begun so far.
    std::uint32_t pivot_ = 0;
    Index closing_ = 0;  ///< Entries of a closed ring whose removal is still to come.
};

}  // namespace se
