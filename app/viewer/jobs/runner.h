/// The open run: it is made once, from start to end, in the background, and moved to any pivot on
/// request in between, while the window stays responsive.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "run/model.h"
#include "run/overview.h"
#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/why/failure_moments.h"
#include "thread.h"

namespace se::view {

/// Result of a request, so far.
struct RunnerAnswer {
    std::shared_ptr<const PivotRecord> record;
    std::vector<Triangle> newTriangles;  ///< After those of all earlier answers.
    bool final = false;                  ///< False: a picture from along the way.
    bool found = true;                   ///< False: no event about the point; nothing moved.
    /// A sentence why the run cannot be continued; then there may be no record. Empty if it can.
    std::string complaint;
};

/// The end of a run, and what was counted on the way.
struct RunEnd {
    std::vector<Triangle> mesh;
    bool capped = false;  ///< Stopped at more triangles than a surface can have (rule `cap`).
    RunCounts counts;
    std::uint64_t stateHash = 0;  ///< stateHash() of the last state.
};

class Runner {
  public:
    explicit Runner(std::shared_ptr<const Model> model);
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;
    /// Waits for the current slice of work; see end().
    ~Runner() = default;

    /// Moves to `pivot`, or to the end if the run is shorter. Requires that no request is open,
    /// that is, that take() has returned the final answer to the one before.
    void request(std::uint32_t pivot) { ask({pivot, kNone}); }
    /// Moves to the first pivot after `pivot` that has an event about `point` (subjectOf()); if
    /// there is none the answer is not `found`. Requires that no request is open.
    void requestPoint(Index point, std::uint32_t pivot) { ask({pivot, point}); }
    /// Ends the open request at its current pivot; its final answer still arrives.
    void cancel() { cancelled_ = true; }
    /// Waits up to `timeout` for the final answer. True if it has arrived.
    bool waitFor(std::chrono::milliseconds timeout);
    /// Results since the last call.
    std::optional<RunnerAnswer> take();
    /// Complaint of the answer that take() has not taken yet, if there is one.
    std::string complaint();
    /// Pivot of the thread; for a progress bar.
    std::uint32_t position() const { return position_; }

    /// Appends to `overview` what was made since the last call. True if anything was.
    bool takeOverview(RunOverview& overview);
    /// The run is made, or will not be.
    bool made() const { return made_; }
    /// Once made(): a sentence why the run was not made to its end, once; empty if it was.
    std::string takeComplaint();
    /// The end of the run; null before it is known.
    std::shared_ptr<const RunEnd> end();
    /// Blocks until the run is made.
    void waitUntilMade();

    /// Ends all work soon: the destructor does not wait once ended().
    void stop() { thread_.cancel(); }
    bool ended() const { return thread_.ended(); }

  private:
    using Clock = std::chrono::steady_clock;
    struct Request {
        std::uint32_t pivot = 0;
        Index point = kNone;  ///< If not kNone: the first event about it after `pivot`.
    };

    void ask(const Request& request);
    Slice work(const CancelFlag& ending);
    void begin();
    void takeRequest();
    void serve();
    bool goTo(std::uint32_t position, const std::function<bool()>& keepGoing);
    void searchPoint(const std::function<bool()>& keepGoing);
    bool makes() const { return observer_.has_value() && !made_ && complaint_.empty(); }
    bool lingers() const;
    void make(const CancelFlag& ending);
    void observed(const std::function<void()>& work);
    void observe(const SweptPivot& pivot);
    void noteEnd();
    void handOver();
    void publish(std::uint32_t pivot, bool final);
    void publishComplaint();

    std::shared_ptr<const Model> model_;
    // Of the thread:
    Timeline timeline_;
    std::optional<RunObserver> observer_;
    RunOverview fresh_;  ///< What was made since it was handed over.
    RunCounts counts_;
    std::optional<Request> serving_;
    bool searching_ = false;  ///< The request is at its pivot, and goes on to its point.
    bool found_ = true;
    std::size_t publishedTriangles_ = 0;
    std::uint32_t servedAt_ = 0;    ///< Where the last request ended.
    Clock::time_point servedLast_;  ///< A request.
    Clock::time_point madeLast_;    ///< A slice of the run.
    /// Text of the exception that the work ended with. The position of the timeline is unknown
    /// then.
    std::string complaint_;

    std::mutex mutex_;
    std::optional<Request> wanted_;  ///< Guarded, as all up to `overview_`.
    bool open_ = false;              ///< A request without its final answer taken.
    std::optional<RunnerAnswer> answer_;
    std::shared_ptr<const RunEnd> end_;
    std::string unmade_;                 ///< Why the run was not made to its end.
    std::vector<RunOverview> overview_;  ///< Handed over.
    std::atomic<bool> made_ = false;
    std::atomic<bool> asked_ = false;  ///< There is a wanted_ request.
    std::atomic<bool> cancelled_ = false;
    std::atomic<std::uint32_t> position_ = 0;
    Thread thread_;  // last: it uses all members above
};

}  // namespace se::view
