/// A point of the open input that the user drags: for each position its pivot is made again, and
/// shown at once. Released, the move becomes a what-if; taken back, the run is unchanged.
#pragma once

#include <memory>
#include <optional>

#include "jobs/background_job.h"
#include "run/model.h"
#include "spiraling_edge/run/moved_pivot.h"
#include "spiraling_edge/stepper/what_if.h"

namespace se::view {

class Session;

class PointDrag {
  public:
    explicit PointDrag(Session& session) : session_(session) {}

    /// Something is shown that is not the open run: a point is held, or the run with its move is
    /// being made.
    bool active() const { return model_ != nullptr; }
    bool held() const { return held_; }
    /// Whether the point can be dragged at the cursor: in a pivot of the paper's run.
    bool possible(Index point) const;

    /// Starts a drag. Requires possible().
    void begin(Index point);
    /// Moves it, in scene units; shows its pivot at once if that is quickly made. Requires held().
    void moveTo(const Vec3& to);
    /// Ends the drag and returns its what-if, whose run is to be made: until that is open the moved
    /// point stays in the picture. Requires held().
    WhatIf release();
    /// Shows the open run again.
    void takeBack();

    // While active().
    Index point() const { return point_; }
    const Vec3& from() const { return from_; }
    const Vec3& to() const { return to_; }
    /// The place on the way on which the verdict of the decision at the cursor changes; empty if it
    /// does not, or before that is known.
    const std::optional<Vec3>& turn() const { return turn_; }
    /// The model with the point where it is.
    const Model& model() const { return *model_; }
    /// Grows with every position of the point.
    std::uint32_t revision() const { return revision_; }

    // By the session.
    /// Takes what the thread has made. True if there was something.
    bool poll();
    /// Discards the drag: another record is shown.
    void forget();
    bool busy() const { return waits_ || job_.busy(); }
    /// Blocks until the pivot for the present position and its turn are made.
    void waitUntilDone();

  private:
    struct Made {
        std::shared_ptr<const MovedPivot> pivot;
        std::shared_ptr<const PivotRecord> record;
        std::optional<Vec3> turn;
        bool complete = false;  ///< The turn has been searched.
    };

    void start();
    bool take();
    void showAtSameStep();

    Session& session_;
    bool held_ = false;
    Index point_ = kNone;
    PointDecisions decisions_;
    Vec3 from_{0.0};
    Vec3 to_{0.0};
    std::optional<Vec3> turn_;
    std::shared_ptr<Model> model_;
    std::shared_ptr<const PivotRecord> open_;  ///< Of the open run.
    std::size_t openCursor_ = 0;
    std::shared_ptr<const MovedPivot> pivot_;  ///< Null before the first answer.
    bool waits_ = false;                       ///< `to_` is not being made yet.
    bool recordTaken_ = false;  ///< The job has delivered its record, and searches the turn.
    BackgroundJob<Made> job_;
    std::uint32_t revision_ = 0;
};

}  // namespace se::view
