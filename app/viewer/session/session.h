/// What is open and where the cursor stands. Knows neither window nor OpenGL.
///
/// The cursor is an address: it stands on an event, and the picture shows the state just after it.
/// Moves are carried out in order; a move that needs a pivot that is not at hand waits for the
/// runner thread, and the picture stays until its answer comes.
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

/// A move that takes so many seconds is shown, and can be stopped.
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

    // Opening. What was open before stays until the new input is ready, or failed.
    void open(InputSpec spec);
    /// Runs what is open again, by other rules or with other what-ifs, in a thread. message() says
    /// where the cursor landed and why; the selection stays. What is refused is told, and all stays
    /// as it is. Requires ready().
    void runAnew(const RuleSet& rules, Resume resume = Resume::SamePlace);
    /// What is open is being run anew.
    bool runsAnew() const { return anew_ && phase_ == SessionPhase::Loading; }
    /// For how long.
    double anewSeconds() const {
        return std::chrono::duration<double>(Clock::now() - anewSince_).count();
    }
    /// The rules of what is open, or of what is about to be.
    RuleSet rules() const { return rulesOf(runsAnew() ? opening_ : spec_); }
    /// Why a what-if of spec() has no effect; empty: it has.
    const std::string& whatIfProblem(std::size_t i) const;
    /// Goes on at once with what was open before, or with nothing.
    void cancelOpening();
    /// After a failure: goes on with what was open before, or with nothing.
    void dismissError() { phase_ = ready() ? SessionPhase::Ready : SessionPhase::Empty; }
    /// Takes over what threads have finished. True if there is something new to draw.
    bool poll();
    /// Blocks until nothing is under way any more: for pictures without a person, and tests.
    void settle();

    SessionPhase phase() const { return phase_; }
    double loadShare() const { return loader_.share(); }
    LoadPart loadPart() const { return loader_.part(); }
    const std::string& error() const { return error_; }
    /// Of what is open.
    const InputSpec& spec() const { return spec_; }
    /// Of what is being opened, or was last: it may have failed.
    const InputSpec& opening() const { return opening_; }

    // What is open. Everything below requires phase() == Ready, or an earlier input still shown.
    bool ready() const { return model_ != nullptr && record_ != nullptr; }
    /// Nothing is open and nothing is on its way: the place to choose something.
    bool startPage() const { return !ready() && phase_ != SessionPhase::Loading; }
    const Model& model() const { return *model_; }
    /// The same with points where what-ifs have moved them, as far as the cursor is: for drawing.
    const Model& shown() const;
    /// For who goes on with it in another thread.
    std::shared_ptr<const Model> sharedModel() const { return model_; }
    /// The input as prepare() took it: what a mesh is written with.
    std::shared_ptr<const PointFile> sharedFile() const { return file_; }
    const PivotRecord& record() const { return *record_; }
    const Picture& picture() const { return picture_; }
    const RunOverview& overview() const { return overview_; }
    /// What the doctor says of the input; it looks once the run was gone through.
    const Checkup& checkup() const { return checkup_; }
    /// What is asked about the run.
    Questions& questions() { return *questions_; }
    const Questions& questions() const { return *questions_; }
    /// True once, when the doctor has found something to accuse.
    bool takeAccusation() { return std::exchange(accused_, false); }
    /// Everything that went wrong in the run; looked for once it was gone through.
    const AlertSearch& alerts() const { return alerts_; }
    void stopAlerts() { alerts_.stop(); }
    void resumeAlerts() { alerts_.resume(); }
    /// True once, when all alerts are known.
    bool takeAlertNews() { return std::exchange(alertNews_, false); }
    /// The alert that is looked at; null if none is.
    const RunFailure* alert() const { return alert_ ? &alerts_.failures()[*alert_] : nullptr; }
    std::optional<std::size_t> chosenAlert() const { return alert_; }
    /// Requires a place in alerts().failures(), or nothing.
    void chooseAlert(std::optional<std::size_t> alert);
    /// Which rules would have prevented the alert that is looked at; asked for by seekRemedies().
    const RemedySearch& remedies() const { return remedies_; }
    /// Requires that an alert is looked at.
    void seekRemedies();
    void stopRemedies() { remedies_.stop(); }
    /// What goes wrong with the event at the cursor.
    std::span<const LiveFailure> noticedHere() const;
    /// The same in words, with a blank before them; empty if all is well.
    std::string noticedText() const;
    /// Triangles seen so far in this run; the first finishedTriangles of the picture are drawn.
    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Those that are there at the cursor: the first of triangles(), or the mended mesh.
    std::span<const Triangle> shownTriangles() const;
    /// Of triangles().
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
    /// The picture is that before the event at the cursor, as long as this is on.
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
    /// To a share of the whole run, in [0, 1]. How long that is is known once it was gone through:
    /// until then it is waited for, and what is known is not taken for the whole.
    void goToShare(double share);
    /// The next (+1) or previous (-1) split, join, seed or alert; nothing if none is known.
    std::optional<Address> nextMark(int direction) const;
    /// Goes to an address and leaves no trace in the history: for playing.
    void playTo(const Address& address) { jump(address); }
    /// The cursor stands at an event or behind it. An address without stage means the whole pivot.
    bool reached(const Address& address) const;
    /// Back and forward through the places that one jumped away from.
    void goBack();
    void goForward();
    const History& history() const { return history_; }
    /// To the next event about a point, behind the cursor; says so if there is none.
    void goToPoint(Index point);
    /// To an event of the present pivot.
    void goToEvent(std::size_t index);
    /// Reads `137`, `137.sphere.3`, `+10`, `-10`, `50%` or `p812` (selects the point and
    /// goes to its next event). Fails with a sentence.
    Status goToText(const std::string& text);

    // Watches.
    void watch(std::span<const std::string> expressions) { watches_.want(expressions); }
    const WatchScan& watches() const { return watches_; }
    WatchScan& watches() { return watches_; }

    // Breakpoints (session_stops.cpp).
    /// Those that there are now; to be called whenever they may have changed.
    void arm(std::span<const Breakpoint> breakpoints) { hits_.want(breakpoints); }
    const HitSearch& hits() const { return hits_; }
    HitSearch& hits() { return hits_; }
    /// To the next (1) or previous (-1) stop, else to the end or the start of the run; waits for
    /// the search where it has not come that far.
    void continueRun(int direction);
    /// A stop is waited for whose place is not known yet.
    bool awaitsStop() const { return awaitedStop_ != 0; }
    /// The first stop behind the cursor, as far as is known.
    HitSearch::Answer stopAhead() const { return hits_.stop(place(), 1); }
    /// Goes to a stop, says which one it is, and leaves no trace in the history.
    void playToStop(const Stop& stop);
    /// Where the cursor stands in the order of the run.
    RunPlace place() const;

    /// A move waits for the runner thread, or for the run to be gone through.
    bool busy() const { return waiting_ || !moves_.empty() || awaitsLength() || awaitsStop(); }
    /// A share of the run was asked for whose length is not known yet.
    bool awaitsLength() const { return awaitedShare_.has_value(); }
    /// How long it has been waited for; 0 if nothing is.
    double busySeconds() const;
    std::uint32_t runnerPosition() const { return runner_ ? runner_->position() : 0; }
    std::uint32_t runnerTarget() const { return requested_; }
    void cancelMove();

    // Selection, by index: it survives every move.
    const Selection& selection() const { return selection_; }
    void select(const Selection& selection);
    /// The point that is selected, kNone if none is or something else.
    Index selected() const {
        return selection_.kind == SelectionKind::Point ? selection_.points[0] : kNone;
    }
    void select(Index point) { select(Selection::ofPoint(point)); }
    /// The point under the pointer, in the view or on the dial; lit up in both.
    Index hovered() const { return hovered_; }
    void hover(Index point);
    /// Points that are lit up, as those of a finding; none by default.
    std::span<const Index> marked() const { return marked_; }
    void mark(std::vector<Index> points);
    Index highlightedRing() const { return highlightedRing_; }
    void highlightRing(Index ring);
    /// The ring under the pointer; it is lit up for so long.
    void hoverRing(Index ring);
    /// The ring to light up: that under the pointer, else the highlighted one.
    Index litRing() const { return hoveredRing_ != kNone ? hoveredRing_ : highlightedRing_; }

    /// The last thing worth saying that is no event, e.g. that an address does not exist.
    const std::string& message() const { return message_; }
    void say(std::string message);
    /// The last move did not find what it looked for; message() says what. False again with the
    /// next move.
    bool missed() const { return missed_; }
    /// The message as long as it is news, then nothing: it must not cover the decision.
    std::string notice(Clock::time_point now = Clock::now()) const;

  private:
    enum class Landing : std::uint8_t { First, Last, AtAddress, AtPoint, AtSamePlace };
    struct Move {
        enum class Kind : std::uint8_t { Events, Pivots, Finish, Go, Point } kind = Kind::Go;
        int delta = 0;
        Address target;
        Index point = kNone;
    };

    /// The pivot at the cursor is the last one, as far as is known.
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
    bool pollCheckup();

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

    /// "137.sphere.3", "0" at the start: what goToText() takes.
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
    bool anew_ = false;  ///< What was asked for last is run anew.
    std::vector<std::string> whatIfProblems_;
    std::vector<MovedModel> moved_;
    SamePlace samePlace_;
    Checkup checkup_;
    AlertSearch alerts_;
    std::optional<std::size_t> alert_;
    bool alertNews_ = false;
    RemedySearch remedies_;
    bool accused_ = false;
    std::vector<Index> marked_;
    std::unique_ptr<Questions> questions_;

    std::unique_ptr<Runner> runner_;
    std::unique_ptr<OverviewJob> overviewJob_;
    Loader loader_;
};

}  // namespace se::view
