/// The open document and its cursor. Independent of window and OpenGL.
///
/// The cursor is an address: it is on an event, and the picture shows the state just after it.
/// The other parts of the document are objects of their own: moves(), input(), alerts(), hits(),
/// watches(), highlights(), messages().
#pragma once

#include <cassert>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "jobs/alert_search.h"
#include "jobs/background_job.h"
#include "jobs/doctor_job.h"
#include "jobs/kept_pass.h"
#include "jobs/runner.h"
#include "moves.h"
#include "run/model.h"
#include "run/overview.h"
#include "run/selection.h"
#include "scene/mesh_index.h"
#include "session_input.h"
#include "spiraling_edge/base/types.h"
#include "spiraling_edge/run/moved_pivot.h"
#include "spiraling_edge/run/pivot_record.h"
#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/stepper/what_if.h"

namespace se::view {

// A point of the open input that the user drags: for each position its pivot is made again, and
// shown at once. Released, the move becomes a what-if; taken back, the run is unchanged.

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

// Messages of the session to the user, beside the decision at the cursor.

class Messages {
  public:
    using Clock = std::chrono::steady_clock;

    void say(std::string message);
    /// Shows an error; nothing if it is empty.
    void sayIfAny(std::string complaint);
    /// Says why a move did not find its target.
    void miss(std::string message);
    /// The last message becomes empty, and nothing is missed: a move begins.
    void clear();

    /// The last message that is not about an event, for example that an address does not exist.
    const std::string& last() const { return message_; }
    /// The message while it is new, then empty: it must not cover the decision.
    std::string notice(Clock::time_point now = Clock::now()) const;
    /// The last move did not find its target; last() gives the reason. False again with the next
    /// move.
    bool missed() const { return missed_; }
    void forgetMiss() { missed_ = false; }

  private:
    std::string message_;
    bool missed_ = false;
    Clock::time_point saidAt_;
};

// Highlights beside the selection: the item under the pointer, the points of a finding,
// and a ring.

class Highlights {
  public:
    /// The point under the pointer, in the view or on the dial; highlighted in both.
    Index hovered() const { return hovered_; }
    void hover(Index point) { change(hovered_, point); }
    /// Points that are highlighted, such as those of a finding; none by default.
    std::span<const Index> marked() const { return marked_; }
    void mark(std::vector<Index> points, std::vector<EvidenceLine> lines = {});
    /// Lines that are highlighted with them.
    std::span<const EvidenceLine> lines() const { return lines_; }
    bool any() const { return !marked_.empty() || !lines_.empty(); }
    /// Points that show their names, such as the possible answers to a question; none by default.
    std::span<const Index> labeled() const { return labeled_; }
    void label(std::vector<Index> points) { change(labeled_, std::move(points)); }
    Index chosenRing() const { return chosenRing_; }
    /// Chooses a ring; none if it was chosen already.
    void chooseRing(Index ring);
    /// Sets the ring under the pointer, which is highlighted.
    void hoverRing(Index ring) { change(hoveredRing_, ring); }
    /// The ring to highlight: the one under the pointer, otherwise the chosen one.
    Index litRing() const { return hoveredRing_ != kNone ? hoveredRing_ : chosenRing_; }
    void clearRings() { chosenRing_ = hoveredRing_ = kNone; }
    /// Grows with every change.
    std::uint32_t revision() const { return revision_; }

  private:
    template <typename Value>
    void change(Value& held, Value value) {
        if (held != value) ++revision_;
        held = std::move(value);
    }

    Index hovered_ = kNone;
    Index chosenRing_ = kNone;
    Index hoveredRing_ = kNone;
    std::vector<Index> marked_;
    std::vector<EvidenceLine> lines_;
    std::vector<Index> labeled_;
    std::uint32_t revision_ = 0;
};

class Questions;

/// The finished mesh of a run, kept while another run of the same points is open.
struct EarlierMesh {
    std::shared_ptr<const std::vector<Triangle>> triangles;
    std::shared_ptr<const RunFailureSearch> faults;  ///< Null: not searched.
    std::optional<std::size_t> place = {};           ///< The place in `faults` that was shown.
};

class Session {
  public:
    Session();
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Opening. The open input stays until the new one is ready, or failed.
    void open(RunSpec spec);
    /// Runs the open input again, with other rules or what-ifs, in a thread. messages() reports
    /// the new cursor position and the reason for it; the selection stays. If the change is
    /// refused, the reason is reported and all stays as it is. Ignored unless ready().
    void rerun(const RunSpec& rules, Resume resume = Resume::SamePosition);
    /// Returns at once to the input that was open before, or to none.
    void cancelOpening();
    /// After a failure: returns to the input that was open before, or to none.
    void dismissError() { input_.dismiss(ready()); }
    /// Takes the results of the threads. True if there is something new to draw.
    bool poll();
    /// Blocks until no work is in progress: for pictures without a user, and tests.
    void waitUntilDone();

    const SessionInput& input() const { return input_; }
    Messages& messages() { return messages_; }
    const Messages& messages() const { return messages_; }

    // The open input. Everything below requires ready().
    /// An input is open: phase() is Ready, or another input is being opened.
    bool ready() const { return model_ != nullptr && record_ != nullptr; }
    /// No input is open and none is being opened: the start page is shown.
    bool startPage() const { return !ready() && input_.phase() != SessionPhase::Loading; }
    const Model& model() const {
        assert(ready());
        return *model_;
    }
    /// The model with points where the user drags them, or where what-ifs have moved them up to the
    /// cursor: for drawing.
    const Model& shown() const;
    /// Shared ownership, for background jobs.
    std::shared_ptr<const Model> sharedModel() const { return model_; }
    /// The names that points are called by; empty: by their numbers.
    std::span<const PointName> names() const {
        if (ready() && showsNames_ && !givenNames_.empty()) return givenNames_;
        const bool here = ready() && (model_->namesIn == 0 || model_->namesIn == record_->pivot);
        return here && showsNames_ ? model_->names : std::span<const PointName>{};
    }
    void showNames(bool on) {
        if (std::exchange(showsNames_, on) != on) ++revision_;
    }
    /// Names instead of those of the model, which the caller keeps; empty: those of the model.
    void giveNames(std::span<const PointName> names) {
        givenNames_ = names;
        ++revision_;
    }
    std::span<const PointName> givenNames() const { return givenNames_; }
    const PivotRecord& record() const {
        assert(ready());
        return *record_;
    }
    /// The states at all decisions of that pivot.
    PivotReplay replay() const { return PivotReplay(record_); }
    const DecisionState& picture() const { return picture_; }
    const RunOverview& overview() const { return overview_; }
    /// The end of the run; null before it is made, and if it cannot be.
    std::shared_ptr<const RunEnd> runEnd() const;
    /// The run is made, or will not be.
    bool isMade() const { return runner_ && runner_->made(); }
    /// Share of the run that is made, in [0, 1]; a guess from the number of triangles.
    double madeShare() const;
    /// Triangles seen so far in this run; the first finishedTriangles of the picture are drawn.
    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Triangles at the cursor: the first of triangles(), or the repaired mesh.
    std::span<const Triangle> shownTriangles() const;
    /// Index of triangles().
    const MeshIndex& meshIndex() const { return meshIndex_; }
    /// Grows when another input is opened or the run restarted: everything uploaded is void.
    std::uint32_t generation() const { return generation_; }
    /// Grows whenever the picture or the selection changes.
    std::uint32_t revision() const {
        return revision_ + highlights_.revision() + alerts_.revision();
    }

    // The cursor.
    std::size_t cursor() const { return cursor_; }
    /// The event at the cursor, null at the beginning.
    const Event* event() const;
    /// The stage of what the picture shows; nothing at the beginning.
    std::optional<Stage> stage() const;
    /// Shows the picture before the event at the cursor, while this is on.
    void showBefore(bool on);
    bool showsBefore() const { return before_; }
    /// The picture is the finished mesh of the run before the last change: at the end of the run,
    /// while showBefore() is on, if that run was at its end and had the same points.
    bool showsEarlierMesh() const { return before_ && earlier_.triangles && atEnd(); }
    const EarlierMesh& earlierMesh() const { return earlier_; }
    bool hasEarlierMesh() const { return earlier_.triangles != nullptr; }
    /// Faults of the finished mesh that is shown; null if they are not known.
    const RunFailureSearch* finishedFaults() const {
        return showsEarlierMesh() ? earlier_.faults.get() : alerts_.found();
    }
    Address address() const;
    /// Position of the cursor in the order of the run.
    RunPosition place() const;
    bool atStart() const { return record_ == nullptr || record_->pivot == 0; }
    bool atEnd() const;
    /// The pivot at the cursor is the last one known so far.
    bool atLastPivot() const;
    /// The cursor is at an event or after it. An address without stage means the whole pivot.
    bool reached(const Address& address) const;
    /// The next (+1) or previous (-1) split, join, seed or alert; empty if none is known.
    std::optional<Address> nextMark(int direction) const;
    /// Failures caused by the event at the cursor.
    std::span<const LiveFailure> noticedHere() const;
    /// The failures in words, after a space; empty if there are none.
    std::string noticedText() const;
    /// The last position that may be shown, that of a question; nothing: the whole run. Moves
    /// beyond it end there.
    void setHorizon(const std::optional<Address>& horizon) { horizon_ = horizon; }
    const std::optional<Address>& horizon() const { return horizon_; }
    Moves& moves() { return moves_; }
    const Moves& moves() const { return moves_; }
    /// The point that the user drags; while there is one, record() is the pivot with it moved.
    PointDrag& drag() { return drag_; }
    const PointDrag& drag() const { return drag_; }

    // Searches in the run.
    RunAlerts& alerts() { return alerts_; }
    const RunAlerts& alerts() const { return alerts_; }
    /// Trials of other settings; started by those who want them.
    TrialJob& trials() { return trials_; }
    const TrialJob& trials() const { return trials_; }
    /// Hits of the breakpoints.
    HitSearch& hits() { return hits_; }
    const HitSearch& hits() const { return hits_; }
    WatchScan& watches() { return watches_; }
    const WatchScan& watches() const { return watches_; }
    /// The user's queries about the run.
    Questions& questions() { return *questions_; }
    const Questions& questions() const { return *questions_; }
    /// The doctor's examination of the input; it starts once the run is complete.
    const DoctorJob& doctorJob() const { return doctorJob_; }
    /// True once, when the doctor has found a problem.
    bool takeProblemFound() { return std::exchange(problemFound_, false); }

    // Selection, by index: it survives every move.
    const Selection& selection() const { return selection_; }
    void select(const Selection& selection);
    /// The selected point; kNone if none or something else is selected.
    Index selected() const {
        return selection_.kind == SelectionKind::Point ? selection_.points[0] : kNone;
    }
    void select(Index point) { select(Selection::ofPoint(point)); }
    Highlights& highlights() { return highlights_; }
    const Highlights& highlights() const { return highlights_; }

  private:
    friend class Moves;      // sets the cursor, in the record that the runner thread has delivered
    friend class PointDrag;  // sets record and cursor

    void setCursor(std::size_t cursor);
    void setCursorToLast();
    void take(RunnerAnswer& answer);
    void adopt(Opened opened);
    void stopRunner();
    void keepFinishedMesh(const Opened& opened);
    void fail(std::string why);
    bool pollLast();

    SessionInput input_;
    Messages messages_;
    std::shared_ptr<const Model> model_;
    std::vector<MovedModel> moved_;
    std::shared_ptr<const PivotRecord> record_;
    std::size_t cursor_ = 0;
    DecisionState picture_;
    bool before_ = false;
    bool showsNames_ = true;
    std::span<const PointName> givenNames_;
    std::optional<Address> horizon_;
    EarlierMesh earlier_;
    std::vector<Triangle> triangles_;
    MeshIndex meshIndex_;
    RunOverview overview_;
    std::uint32_t generation_ = 0;
    std::uint32_t revision_ = 0;
    Selection selection_;
    Highlights highlights_;

    Moves moves_;
    PointDrag drag_;
    RunAlerts alerts_;
    TrialJob trials_;
    HitSearch hits_;
    WatchScan watches_;
    DoctorJob doctorJob_;
    bool problemFound_ = false;
    std::unique_ptr<Questions> questions_;
    std::unique_ptr<Runner> runner_;
    std::vector<std::unique_ptr<Runner>> stopped_;  ///< Until they have ended.
};

}  // namespace se::view
