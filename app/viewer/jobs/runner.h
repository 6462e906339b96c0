/// The thread that owns the timeline: it moves to any pivot while the window stays responsive.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>

#include "run/model.h"
#include "spiraling_edge/replay/timeline.h"
#include "thread.h"

namespace se::view {

/// Result of the thread, so far.
struct RunnerAnswer {
    std::shared_ptr<const PivotRecord> record;
    std::vector<Triangle> newTriangles;  ///< After those of all earlier answers.
    bool final = false;                  ///< False: a picture from along the way.
    bool found = true;                   ///< False: no event about the point; nothing moved.
    /// A sentence why the thread cannot continue; then there may be no record. Empty if it can.
    std::string complaint;
};

class Runner {
  public:
    explicit Runner(std::shared_ptr<const Model> model);
    ~Runner();
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    /// Moves to `pivot`, or to the end if the run is shorter. Requires that no request is open,
    /// that is, that take() has returned the final answer to the one before.
    void request(std::uint32_t pivot);
    /// Moves to the first pivot after `pivot` that has an event about `point` (subjectOf()); if
    /// there is none the answer is not `found`. Requires that no request is open.
    void requestPoint(Index point, std::uint32_t pivot);
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

  private:
    void work();
    struct Request {
        std::uint32_t pivot = 0;
        Index point = kNone;  ///< If not kNone: the first event about it after `pivot`.
    };
    void ask(const Request& request);
    void serve(std::uint32_t pivot);
    void servePoint(const Request& request);
    bool goTo(std::uint32_t position);
    void publish(std::uint32_t pivot, bool final);
    void publishComplaint();

    std::shared_ptr<const Model> model_;
    Timeline timeline_;
    std::size_t publishedTriangles_ = 0;
    bool found_ = true;
    /// Text of the exception that a request ended with. The position of the timeline is unknown
    /// then.
    std::string complaint_;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Request> wanted_;
    bool open_ = false;    ///< A request without its final answer taken; under the mutex.
    bool ending_ = false;  ///< Under the mutex, as `wanted_`.
    std::optional<RunnerAnswer> answer_;
    std::atomic<bool> cancelled_ = false;
    std::atomic<std::uint32_t> position_ = 0;
    Thread thread_;  // last: it uses all members above
};

}  // namespace se::view
