/// The thread that owns the timeline: it goes to a pivot, however far, while the window stays
/// awake.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>

#include "run/model.h"
#include "run/pivot_record.h"
#include "thread.h"

namespace se::view {

/// What the thread found, so far.
struct RunnerAnswer {
    std::shared_ptr<const PivotRecord> record;
    std::vector<Triangle> newTriangles;  ///< Behind those of all earlier answers.
    bool final = false;                  ///< False: a look at a place on the way.
    bool found = true;                   ///< False: no event about the point; nothing moved.
    /// Why the thread cannot go on, a sentence; then there may be no record. Empty if it can.
    std::string complaint;
};

class Runner {
  public:
    explicit Runner(std::shared_ptr<const Model> model);
    ~Runner();
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    /// Goes to `pivot`, or the end if the run is shorter. Requires that no request is open, that
    /// is, that take() has returned the final answer to the one before.
    void request(std::uint32_t pivot);
    /// Goes to the first pivot behind `pivot` that has an event about `point` (subjectOf()); if
    /// there is none the answer is not `found`. Requires what request() does.
    void requestPoint(Index point, std::uint32_t pivot);
    /// Makes the open request end where it is; its final answer still comes.
    void cancel() { cancelled_ = true; }
    /// Waits up to `patience` for the final answer. True if it is there.
    bool wait(std::chrono::milliseconds patience);
    /// What was found since the last call.
    std::optional<RunnerAnswer> take();
    /// That of the answer that take() has not taken yet, if there is one.
    std::string complaint();
    /// Where the thread is; for a progress bar.
    std::uint32_t position() const { return position_; }

  private:
    void work();
    struct Request {
        std::uint32_t pivot = 0;
        Index point = kNone;  ///< If not kNone: the first event about it behind `pivot`.
    };
    void ask(const Request& request);
    void serve(std::uint32_t pivot);
    void servePoint(const Request& request);
    bool goTo(std::uint32_t position);
    void publish(std::uint32_t pivot, bool final);
    void publishComplaint();

    std::shared_ptr<const Model> model_;
    Timeline timeline_;
    StatusList status_;  ///< Of the last record.
    std::size_t publishedTriangles_ = 0;
    bool found_ = true;
    /// Of the exception that a request ended with. The timeline may be anywhere since.
    std::string complaint_;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Request> wanted_;
    bool ending_ = false;  ///< Under the mutex, as `wanted_`.
    std::optional<RunnerAnswer> answer_;
    std::atomic<bool> cancelled_ = false;
    std::atomic<std::uint32_t> position_ = 0;
    Thread thread_;  // last: it uses all of the above
};

}  // namespace se::view
