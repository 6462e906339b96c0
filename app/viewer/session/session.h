/// The open document and its cursor. Independent of window and OpenGL.
///
/// The cursor is an address: it is on an event, and the picture shows the state just after it.
/// Moves are carried out in order; a move to a pivot that is not in memory waits for the
/// runner thread, and the picture stays until its answer arrives.
#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>

#include "history.h"
#include "jobs/alert_search.h"
#include "jobs/doctor_job.h"
#include "jobs/hit_search.h"
#include "jobs/loader.h"
#include "jobs/overview_job.h"
#include "jobs/remedy_search.h"
#include "jobs/runner.h"
#include "jobs/watch_scan.h"
#include "run/model.h"
#include "run/overview.h"
#include "run/picture.h"
#include "run/pivot_record.h"
#include "run/selection.h"
#include "scene/mesh_index.h"

namespace se::view {

/// Seconds after which a move is shown with a button to stop it.
inline constexpr double kLongMove = 0.15;

class Questions;

enum class SessionPhase : std::uint8_t { Empty, Loading, Ready, Failed };

class Session {
  public:
    using Clock = std::chrono::steady_clock;

    Session();
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Opening. The open input stays until the new one is ready, or failed.
    void open(InputSpec spec);
    /// Runs the open input again, with other rules or what-ifs, in a thread. message() reports the
    /// new cursor position and the reason for it; the selection stays. If the change is refused,
    /// the reason is reported and all stays as it is. Requires ready().
    void runAnew(const RuleSet& rules, Resume resume = Resume::SamePosition);
    /// The open input is being re-run.
    bool runsAnew() const { return anew_ && phase_ == SessionPhase::Loading; }
    /// Seconds since the re-run began.
    double anewSeconds() const {
        return std::chrono::duration<double>(Clock::now() - anewSince_).count();
    }
    /// The rules of the open input, or of the one that is being opened.
    RuleSet rules() const { return rulesOf(runsAnew() ? opening_ : spec_); }
    /// Reason why a what-if of spec() has no effect; empty if it has one.
    const std::string& whatIfProblem(std::size_t i) const;
    /// Returns at once to the input that was open before, or to none.
    void cancelOpening();
    /// After a failure: returns to the input that was open before, or to none.
    void dismissError() { phase_ = ready() ? SessionPhase::Ready : SessionPhase::Empty; }
    /// Takes the results of the threads. True if there is something new to draw.
    bool poll();
    /// Blocks until no work is in progress: for pictures without a user, and tests.
    void waitUntilDone();

    SessionPhase phase() const { return phase_; }
    double loadShare() const { return loader_.share(); }
    LoadPart loadPart() const { return loader_.part(); }
    const std::string& error() const { return error_; }
    /// Specification of the open input.
    const InputSpec& spec() const { return spec_; }
    /// Specification of the last opening, which may have failed.
    const InputSpec& opening() const { return opening_; }

    // The open input. Everything below requires phase() == Ready, or an earlier input still shown.
    bool ready() const { return model_ != nullptr && record_ != nullptr; }
    /// No input is open and none is being opened: the start page is shown.
    bool startPage() const { return !ready() && phase_ != SessionPhase::Loading; }
    const Model& model() const { return *model_; }
    /// The model with points where what-ifs have moved them up to the cursor: for drawing.
    const Model& shown() const;
    /// Shared ownership, for background jobs.
    std::shared_ptr<const Model> sharedModel() const { return model_; }
    /// Input of prepare(), with which a mesh is written.
    std::shared_ptr<const PointFile> sharedFile() const { return file_; }
    const PivotRecord& record() const { return *record_; }
    const Picture& picture() const { return picture_; }
    const RunOverview& overview() const { return overview_; }
    /// The doctor's examination of the input; it starts once the run is complete.
    const DoctorJob& doctorJob() const { return doctorJob_; }
    /// The user's queries about the run.
    Questions& questions() { return *questions_; }
    const Questions& questions() const { return *questions_; }
    /// True once, when the doctor has found a problem.
    bool takeProblemFound() { return std::exchange(problemFound_, false); }
    /// Search for all failures of the run; it starts once the run is complete.
    const AlertSearch& alerts() const { return alerts_; }
    void stopAlerts() { alerts_.stop(); }
    void resumeAlerts() { alerts_.resume(); }
    /// True once, when all alerts are known.
    bool takeAlertNews() { return std::exchange(alertNews_, false); }
    /// The alert that is shown; null if none is.
    const RunFailure* alert() const { return alert_ ? &alerts_.failures()[*alert_] : nullptr; }
    std::optional<std::size_t> chosenAlert() const { return alert_; }
    /// Sets a position in alerts().failures(), or none.
    void chooseAlert(std::optional<std::size_t> alert);
    /// Rules that would have prevented the alert that is shown; started by seekRemedies().
    const RemedySearch& remedies() const { return remedies_; }
    /// Requires that an alert is shown.
    void seekRemedies();
    void stopRemedies() { remedies_.stop(); }
    /// Failures caused by the event at the cursor.
    std::span<const LiveFailure> noticedHere() const;
    /// The failures in words, after a space; empty if there are none.
    std::string noticedText() const;
    /// Triangles seen so far in this run; the first finishedTriangles of the picture are drawn.
    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Triangles at the cursor: the first of triangles(), or the repaired mesh.
    std::span<const Triangle> shownTriangles() const;
    /// Index of triangles().
    const MeshIndex& meshIndex() const { return meshIndex_; }
    /// Grows when another input is opened or the run restarted: everything uploaded is void.
    std::uint32_t generation() const { return generation_; }
    /// Grows whenever the picture or the selection changes.
    std::uint32_t revision() const { return revision_; }

    // The cursor.
    std::size_t cursor() const { return cursor_; }
    /// The event at the cursor, null at the beginning.
    const Event* event() const;
    /// The stage of what the picture shows; nothing at the beginning.
    std::optional<Stage> stage() const;
    /// Shows the picture before the event at the cursor, while this is on.
    void showBefore(bool on);
    bool showsBefore() const { return before_; }
    Address address() const;
    bool atStart() const { return record_ == nullptr || record_->pivot == 0; }
    bool atEnd() const;

    // Moves.
    void stepEvent(int delta);
    void stepPivot(int delta);
    /// To the last event of this pivot; from there, of the next.
    void finishPivot();
    void toStart() { goToPivot(0); }
    void toEnd();
    /// To the last event of a pivot.
    void goToPivot(std::uint32_t pivot);
    /// To an event; without stage and n to the last event of the pivot.
    void goTo(const Address& address);
    /// To a share of the whole run, in [0, 1]. Waits until the overview of the run is complete,
    /// since its length is not known before.
    void goToShare(double share);
    /// The next (+1) or previous (-1) split, join, seed or alert; empty if none is known.
    std::optional<Address> nextMark(int direction) const;
    /// Goes to an address without an entry in the history: for playing.
    void playTo(const Address& address) { jump(address); }
    /// The cursor is at an event or after it. An address without stage means the whole pivot.
    bool reached(const Address& address) const;
    /// Back and forward through the positions that were left by jumps.
    void goBack();
    void goForward();
    const History& history() const { return history_; }
    /// To the next event about a point, after the cursor; reports if there is none.
    void goToPoint(Index point);
    /// To an event of the current pivot.
    void goToEvent(std::size_t index);
    /// Parses `137`, `137.sphere.3`, `+10`, `-10`, `50%` or `p812` (selects the point and
    /// goes to its next event). Fails with a sentence.
    Status goToText(const std::string& text);

    // Watches.
    void watch(std::span<const std::string> expressions) { watches_.want(expressions); }
    const WatchScan& watches() const { return watches_; }
    WatchScan& watches() { return watches_; }

    // Breakpoints (session_stops.cpp).
    /// Sets the breakpoints; to be called whenever they may have changed.
    void arm(std::span<const Breakpoint> breakpoints) { hits_.want(breakpoints); }
    const HitSearch& hits() const { return hits_; }
    HitSearch& hits() { return hits_; }
    /// To the next (1) or previous (-1) stop, otherwise to the end or the start of the run; waits
    /// for the search if it has not come that far.
    void continueRun(int direction);
    /// The next stop is awaited, and its position is not known yet.
    bool awaitsStop() const { return awaitedStop_ != 0; }
    /// The first stop after the cursor that is known so far.
    HitSearch::Answer stopAhead() const { return hits_.stop(place(), 1); }
    /// Goes to a stop and reports its name, without an entry in the history.
    void playToStop(const Stop& stop);
    /// Position of the cursor in the order of the run.
    RunPosition place() const;

    /// A move waits for the runner thread, or for the overview to be complete.
    bool busy() const { return waiting_ || !moves_.empty() || awaitsLength() || awaitsStop(); }
    /// A move to a share of the run waits for the length of the run.
    bool awaitsLength() const { return awaitedShare_.has_value(); }
    /// Seconds since the wait began; 0 without a wait.
    double busySeconds() const;
    std::uint32_t runnerPosition() const { return runner_ ? runner_->position() : 0; }
    std::uint32_t runnerTarget() const { return requested_; }
    void cancelMove();

    // Selection, by index: it survives every move.
    const Selection& selection() const { return selection_; }
    void select(const Selection& selection);
    /// The selected point; kNone if none or something else is selected.
    Index selected() const {
        return selection_.kind == SelectionKind::Point ? selection_.points[0] : kNone;
    }
    void select(Index point) { select(Selection::ofPoint(point)); }
    /// The point under the pointer, in the view or on the dial; highlighted in both.
    Index hovered() const { return hovered_; }
    void hover(Index point);
    /// Points that are highlighted, such as those of a finding; none by default.
    std::span<const Index> marked() const { return marked_; }
    void mark(std::vector<Index> points);
    Index highlightedRing() const { return highlightedRing_; }
    void highlightRing(Index ring);
    /// Sets the ring under the pointer, which is highlighted.
    void hoverRing(Index ring);
    /// The ring to highlight: the one under the pointer, otherwise the chosen one.
    Index litRing() const { return hoveredRing_ != kNone ? hoveredRing_ : highlightedRing_; }

    /// The last message that is not about an event, for example that an address does not exist.
    const std::string& message() const { return message_; }
    void say(std::string message);
    /// The last move did not find its target; message() gives the reason. False again with the
    /// next move.
    bool missed() const { return missed_; }
    /// The message while it is new, then empty: it must not cover the decision.
    std::string notice(Clock::time_point now = Clock::now()) const;

  private:
    enum class Landing : std::uint8_t { First, Last, AtAddress, AtPoint, AtSamePosition };
    struct Move {
        enum class Kind : std::uint8_t { Events, Pivots, Finish, Go, Point } kind = Kind::Go;
        int delta = 0;
        Address target;
        Index point = kNone;
    };

    /// The pivot at the cursor is the last one known so far.
    bool atLastPivot() const;
    void push(Move move);
    void processMoves();
    void goToAwaited();
    void goToAwaitedStop();
    std::string nameOf(const Stop& stop) const;
    void perform(Move move);
    void performEvents(int delta);
    void performPoint(Index point);
    void await(std::uint32_t pivot);
    void request(std::uint32_t pivot, Landing landing, const Address& target = {});
    bool takeAnswer();
    void land();
    void miss(std::string message);
    void sayIfAny(std::string complaint);
    void setCursor(std::size_t cursor);
    void adopt(Opened opened);
    void fail(std::string why);
    bool pollDoctor();

    InputSpec spec_;
    InputSpec opening_;
    SessionPhase phase_ = SessionPhase::Empty;
    std::string error_;
    std::string message_;
    bool missed_ = false;
    Clock::time_point saidAt_;
    std::shared_ptr<const Model> model_;
    std::shared_ptr<const PointFile> file_;
    std::shared_ptr<const PivotRecord> record_;
    std::size_t cursor_ = 0;
    Picture picture_;
    bool before_ = false;
    std::vector<Triangle> triangles_;
    MeshIndex meshIndex_;
    RunOverview overview_;
    Selection selection_;
    Index hovered_ = kNone;
    Index highlightedRing_ = kNone;
    Index hoveredRing_ = kNone;
    std::uint32_t generation_ = 0;
    std::uint32_t revision_ = 0;

    /// "137.sphere.3", "0" at the start: text for goToText().
    std::string hereText() const;
    void jump(const Address& address);

    History history_;
    std::deque<Move> moves_;
    bool waiting_ = false;
    std::optional<double> awaitedShare_;
    int awaitedStop_ = 0;  ///< 1: the next, -1: the previous one; 0: none.
    std::chrono::steady_clock::time_point waitingSince_;
    std::uint32_t requested_ = 0;
    Landing landing_ = Landing::Last;
    Address target_;
    Index pointWanted_ = kNone;

    HitSearch hits_;
    WatchScan watches_;
    Clock::time_point anewSince_;
    bool anew_ = false;  ///< The last opening is a re-run.
    std::vector<std::string> whatIfProblems_;
    std::vector<MovedModel> moved_;
    SamePosition samePosition_;
    DoctorJob doctorJob_;
    AlertSearch alerts_;
    std::optional<std::size_t> alert_;
    bool alertNews_ = false;
    RemedySearch remedies_;
    bool problemFound_ = false;
    std::vector<Index> marked_;
    std::unique_ptr<Questions> questions_;

    std::unique_ptr<Runner> runner_;
    std::unique_ptr<OverviewJob> overviewJob_;
    Loader loader_;
};

}  // namespace se::view
