/// Random access to the pivots of a run, forward and back: keyframes under a byte budget and
/// re-stepping.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "spiraling_edge/run/pivot_record.h"
#include "spiraling_edge/run/repair_history.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {

/// An append-only list of a State during moves back and forth: elements beyond the current place
/// are stored aside, so that each is in memory once.
template <typename T>
class RewoundTail {
  public:
    /// Makes `list` its first `count` elements; `count` may exceed its size up to the longest seen.
    void resize(std::vector<T>& list, std::size_t count) {
        for (; list.size() > count; list.pop_back()) later_.push_back(list.back());
        for (; list.size() < count; later_.pop_back()) list.push_back(later_.back());
    }
    /// Drops the stored elements that a step has just appended again, `count` of them.
    void appended(std::size_t count) {
        later_.resize(later_.size() - std::min(count, later_.size()));
    }

  private:
    std::vector<T> later_;  // the next one last
};

/// A cursor over a run. It is always between two pivots: "at pivot n" means that n pivots are
/// complete; 0 is the beginning. RunCursor goes to single decisions. The points must pass
/// validate().
///
/// A keyframe holds the parts that do not follow from the append-only lists of a State (triangles,
/// alerts, DONE points): the rings and a few numbers. So its size is proportional to the length of
/// the rings, and the cost of restoring it to the changes since; neither depends on the number of
/// points. After the last pivot, with the rules that edit the mesh, there are no keyframes: the
/// steps are undone and redone one by one.
class Timeline {
  public:
    /// A budget that adds a fifth to the memory of the plain run, but at least 32 MB.
    static std::size_t defaultBudget(const PointSet& points);

    Timeline(const SharedPoints& points, const Params& params)
        : Timeline(points, params, defaultBudget(*points)) {}
    /// `byteBudget`: approximate limit for all keyframes together, in bytes.
    Timeline(SharedPoints points, const Params& params, std::size_t byteBudget);
    // A copy of a State has no journal, without which the steps after the last pivot cannot be
    // undone.
    Timeline(const Timeline&) = delete;
    Timeline& operator=(const Timeline&) = delete;
    Timeline(Timeline&&) noexcept = default;
    Timeline& operator=(Timeline&&) noexcept = default;
    ~Timeline() = default;

    const State& state() const { return stepper_.state(); }
    /// Pivots completed at the cursor.
    std::uint32_t position() const { return state().counters.pivots; }
    /// Pivots of the whole run, known once the end was reached; else the farthest seen so far.
    std::uint32_t farthest() const { return farthest_; }
    bool endKnown() const { return endKnown_; }
    /// The highest number that record() has events for. Requires endKnown(). One more than the
    /// pivots of the run, for its end and points that cannot begin a ring, unless it was stopped.
    std::uint32_t lastPivot() const {
        assert(endKnown_);
        return farthest_ + (tail_ ? 1U : 0U);
    }
    /// Approximate size of all keyframes, in bytes.
    std::size_t keyframeBytes() const { return keyframeBytes_; }

    /// Sets a visitor that gets each pivot when it is made for the first time, in order. It must
    /// not throw. Requires that no pivot was made.
    void setVisitor(PivotVisitor visit) {
        assert(farthest_ == 0 && !endKnown_);
        visit_ = std::move(visit);
    }

    /// Completes one more pivot, with its events in `log` unless that is null. False if there is
    /// none: then the run is complete.
    bool stepPivot(EventLog* log = nullptr);
    /// Goes to the place where `pivot` pivots are complete, or to the end if the run is shorter.
    /// Steps after the last pivot are run only if `pivot` is beyond it. Stops early, before the
    /// target, if `keepGoing` returns false (called at intervals).
    void seek(std::uint32_t pivot, const std::function<bool()>& keepGoing = {});
    /// Makes what is left of the run, for the visitor and the end. Steps after the last pivot are
    /// not kept, unless a seek has come to one of them, since those of a large run take as much
    /// memory as all the rest: a later seek makes them again. Stops early as seek() does.
    void makeRest(const std::function<bool()>& keepGoing = {});
    /// Pivot number `pivot`, or the last one if the run is shorter; the cursor is moved to the end
    /// of it. Its statuses share with those of the last call what has not changed.
    std::shared_ptr<const PivotRecord> record(std::uint32_t pivot);

    const PointSet& points() const { return stepper_.points(); }
    const Params& params() const { return stepper_.params(); }

  private:
    struct Keyframe {
        /// Without the lists, the statuses, the edge table, the points' entries and the edited
        /// mesh.
        State rest;
        std::size_t triangles = 0;
        std::size_t alerts = 0;
        std::size_t done = 0;
        std::size_t bytes = 0;
    };

    Keyframe makeKeyframe();
    void storeKeyframe();
    RunState runState();
    void changeState(const std::function<void(State&)>& change);
    bool inRepairs() const { return !state().repair.empty(); }
    void stepTo(std::uint32_t pivot, const std::function<bool()>& keepGoing);
    bool goToRepair(std::size_t place);
    void noteRepair();
    void thinOut();
    void restore(const Keyframe& keyframe);

    Stepper stepper_;
    PivotVisitor visit_;
    EventLog firstLog_;  ///< Events for the visitor, where the caller passes no log.
    std::map<std::uint32_t, Keyframe> keyframes_;
    RepairHistory repairs_;
    Keyframe firstRepair_;  ///< At the first place of `repairs_`.
    RewoundTail<Triangle> triangles_;
    RewoundTail<Alert> alerts_;
    RewoundTail<Index> done_;
    StatusList recorded_;  ///< Of the last record.
    std::size_t byteBudget_;
    std::size_t keyframeBytes_ = 0;
    std::uint32_t spacing_ = 16;  ///< Pivots between keyframes; doubles when the budget is full.
    std::uint32_t farthest_ = 0;
    bool endKnown_ = false;
    bool tail_ = false;        ///< There are events after the last pivot.
    bool beyondLast_ = false;  ///< The cursor is after the events that follow the last pivot.
    bool passes_ = false;      ///< Steps after the last pivot are not kept.
};

}  // namespace se
