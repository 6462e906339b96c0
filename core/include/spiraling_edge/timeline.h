/// Going to any pivot of a run, forward and back: keyframes under a byte budget and re-stepping.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "spiraling_edge/stepper.h"

namespace se {

/// A cursor over a run. It always stands between two pivots: "at pivot n" means that n pivots are
/// complete; 0 is the beginning. points must outlive it and pass validate().
class Timeline {
  public:
    static constexpr std::size_t kDefaultBudget = std::size_t{256} << 20U;

    Timeline(const PointSet& points, const Params& params, std::size_t byteBudget = kDefaultBudget);

    const State& state() const { return stepper_.state(); }
    /// Pivots completed at the cursor.
    std::uint32_t position() const { return state().counters.pivots; }
    /// Pivots of the whole run, known once the end was reached; else the farthest seen so far.
    std::uint32_t farthest() const { return farthest_; }
    bool endKnown() const { return endKnown_; }
    /// The highest number that eventsOf() has events for. Requires endKnown(). One more than the
    /// pivots of the run if something still happens after the last of them, such as points that
    /// nothing can be begun with.
    std::uint32_t lastPivot() const { return farthest_ + (tail_ ? 1U : 0U); }

    /// Completes one more pivot. False if there is none: then what is left to do has been done.
    bool stepPivot();
    /// Goes to the place where `pivot` pivots are complete, or to the end if the run is shorter.
    /// What happens after the last pivot is run only if `pivot` is beyond it.
    /// Stops early, at some place on the way, if `keepGoing` returns false (asked every so often).
    void seek(std::uint32_t pivot, const std::function<bool()>& keepGoing = {});
    /// The events of pivot number `pivot`, made by running it again with a log; the cursor is moved
    /// to pivot - 1 complete pivots. Empty if the run is shorter.
    std::vector<Event> eventsOf(std::uint32_t pivot);

    const PointSet& points() const { return stepper_.points(); }
    const Params& params() const { return stepper_.params(); }

  private:
    /// A State without its append-only lists, whose lengths suffice.
    struct Keyframe {
        State state;
        std::size_t triangleCount = 0;
        std::size_t alertCount = 0;
    };

    Keyframe makeKeyframe();
    void rememberKeyframe();
    void thinOut();
    void restore(const Keyframe& keyframe);

    Stepper stepper_;
    std::map<std::uint32_t, Keyframe> keyframes_;
    std::vector<Triangle> knownTriangles_;  ///< Of the farthest place seen.
    std::vector<Alert> knownAlerts_;
    std::size_t byteBudget_;
    std::size_t keyframeBytes_ = 0;
    std::uint32_t spacing_ = 16;  ///< Pivots between keyframes; doubles when the budget is full.
    std::uint32_t farthest_ = 0;
    bool endKnown_ = false;
    bool tail_ = false;        ///< Something happens after the last pivot.
    bool beyondLast_ = false;  ///< The cursor stands behind what happens after the last pivot.
};

}  // namespace se
