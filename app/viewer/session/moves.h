/// Moves of the cursor: carried out in order, by the runner thread where a pivot is not at hand.
///
/// A move to a pivot that is not in memory waits for that thread, and the picture stays until its
/// answer arrives.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jobs/runner.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/run/breakpoint.h"
#include "spiraling_edge/run/pivot_record.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"

namespace se::view {

// The matching cursor position in another run over the same points: with other rules, or a
// what-if.

/// Target of the cursor in a run with other rules.
enum class Resume : std::uint8_t {
    SamePosition,  ///< The same position by state, see findSamePosition().
    End,           ///< To the end of the new run.
};

/// A run, by its inputs.
struct RunInput {
    const PointSet& points;
    const Params& params;
};

/// Cursor position in the old run.
struct CursorPosition {
    Address address;
    Index subject = kNone;  ///< Subject point of the event.
    bool atEnd = false;     ///< No event of the run follows.
};

/// Cursor position in the new run.
struct SamePosition {
    enum class Kind : std::uint8_t {
        Start,    ///< It was at the start of the run.
        End,      ///< It was at the end of the run.
        Same,     ///< The same pivot of the same component: the same point, for the same number of
                  ///< times.
        Earlier,  ///< There is no such pivot: the nearest earlier state that both runs share.
    };
    Kind kind = Kind::Start;
    CursorPosition from;
    std::uint32_t pivot = 0;
    Index point = kNone;     ///< The pivot that was searched for.
    std::uint32_t part = 0;  ///< The first pivot in which the runs differ; 0: no difference found.
};

/// Runs both as far as needed; empty if `keepGoing` returns false. A component is identified
/// by its first pivot, a pivot by its point and by how often that was pivot of the component
/// before. Deterministic. O(both runs).
std::optional<SamePosition> findSamePosition(const RunInput& before, const CursorPosition& from,
                                             const RunInput& after,
                                             const std::function<bool()>& keepGoing = {});

/// The event of a pivot that matches one of another run, with that address and subject: the same
/// test of the same point; otherwise another test of that stage, or the end of the last stage
/// before it. 0 without events.
std::size_t eventLike(std::span<const Event> events, const Address& wanted, Index subject);
/// The matching event of a pivot in the new run: that of eventLike(), or the last one.
std::size_t sameStep(const PivotRecord& record, const SamePosition& place);

/// The new cursor position and the reason for it: one sentence, shown as a notice.
std::string describe(const SamePosition& place, const Address& landed);

/// Seconds after which a move is shown with a button to stop it.
inline constexpr double kLongMove = 0.15;

class Session;

/// History of positions that were left by jumps, as in a browser. Plain values.
class History {
  public:
    /// Records a jump from `place`. The forward history is cleared.
    void leave(std::string place);
    /// Goes back from `here`; empty if there is no position before it.
    std::optional<std::string> back(std::string here);
    std::optional<std::string> forward(std::string here);

  private:
    static constexpr std::size_t kMax = 200;
    std::vector<std::string> before_;  // the last element is the nearest
    std::vector<std::string> after_;
};

class Moves {
  public:
    using Clock = std::chrono::steady_clock;

    explicit Moves(Session& session) : session_(session) {}

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
    /// To a share of the whole run, in [0, 1]. Waits until the run is made, since its length
    /// is not known before.
    void goToShare(double share);
    /// To the next event about a point, after the cursor; reports if there is none.
    void goToPoint(Index point);
    /// To an event of the current pivot.
    void goToEvent(std::size_t index);
    /// Parses `137`, `137.sphere.3`, `+10`, `-10`, `50%` or `p812` (selects the point and
    /// goes to its next event). Fails with a sentence.
    Status goToText(const std::string& text);
    /// Goes to an address without an entry in the history: for playing.
    void playTo(const Address& address) { jump(address); }
    /// Back and forward through the positions that were left by jumps.
    void goBack();
    void goForward();
    const History& history() const { return history_; }

    // To breakpoints.
    /// To the next (1) or previous (-1) stop, otherwise to the end or the start of the run; waits
    /// for the search if it has not come that far.
    void continueRun(int direction);
    /// The next stop is awaited, and its position is not known yet.
    bool awaitsStop() const { return awaitedStop_ != 0; }
    /// Goes to a stop and reports its name, without an entry in the history.
    void playToStop(const Stop& stop);

    /// A move waits for the runner thread, or for the run to be made.
    bool busy() const { return waiting_ || !moves_.empty() || awaitsLength() || awaitsStop(); }
    /// A move to a share of the run waits for the length of the run.
    bool awaitsLength() const { return awaitedShare_.has_value(); }
    /// Seconds since the wait began; 0 without a wait.
    double busySeconds() const;
    std::uint32_t runnerPosition() const;
    std::uint32_t runnerTarget() const { return requested_; }
    void cancel();

    // By the session.
    /// Begins in another run, whose runner has its first answer ready. The cursor is at the start,
    /// or at `place`.
    void open(const std::optional<SamePosition>& place);
    /// Takes the answer of the runner thread. True if there was one.
    bool poll();
    /// Makes the moves that waited for the length of the run; requires that it is known.
    void goToAwaited();
    void goToAwaitedStop();
    /// Waits a while for the answer that a move needs; none: returns at once.
    void wait();

  private:
    /// A move that waits for those before it.
    using Move = std::function<void()>;
    /// The event of a pivot at which the cursor lands there.
    using Landing = std::function<std::size_t(const PivotRecord& record)>;

    const PivotRecord& record() const;
    void push(Move move);
    void processMoves();
    void moveEvents(int delta);
    void movePivots(int delta);
    void moveToLastEvent();
    void moveTo(const Address& target);
    void moveToPoint(Index point);
    void request(const Address& target, Landing landing);
    void await(std::uint32_t pivot);
    bool takeAnswer();
    void land();
    std::size_t eventAt(const PivotRecord& record, const Address& target);
    std::size_t lastOf(const PivotRecord& record, std::uint32_t pivot);
    void jump(const Address& address);
    void jump(const std::optional<std::string>& place);
    std::string hereText() const;
    std::string nameOf(const Stop& stop) const;
    bool stopsAtQuestion();

    Session& session_;
    History history_;
    std::deque<Move> moves_;
    bool waiting_ = false;
    std::optional<double> awaitedShare_;
    int awaitedStop_ = 0;  ///< 1: the next, -1: the previous one; 0: none.
    Clock::time_point waitingSince_;
    std::uint32_t requested_ = 0;
    Landing landing_;    ///< Of the move that waits for the runner thread.
    bool found_ = true;  ///< The last answer has the point that was searched for.
};

}  // namespace se::view
