/// A background job that goes through a run in a thread of its own and streams its results to the
/// caller. A cancelled job finishes in the background.
#pragma once

#include <atomic>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "guarded.h"
#include "thread.h"

namespace se::view {

template <typename Found>
class RunErrand {
    struct Job {
        std::mutex mutex;
        std::vector<Found> handed;  ///< Not yet taken; guarded.
        std::atomic<double> share = 0.0;
        std::string complaint;         ///< Valid once the job has ended.
        std::optional<Thread> thread;  // last: it uses all members above
    };

  public:
    /// Collector of the results of the work.
    class Basket {
      public:
        Basket(Job& job, const CancelFlag& cancelled) : job_(job), cancelled_(cancelled) {}
        void add(Found found) { fresh_.push_back(std::move(found)); }
        /// Delivers the results; to be called now and then. False if the job was cancelled.
        bool report(double share) {
            job_.share = share;
            const std::lock_guard lock(job_.mutex);
            std::move(fresh_.begin(), fresh_.end(), std::back_inserter(job_.handed));
            fresh_.clear();
            return !cancelled_.isSet();
        }

      private:
        Job& job_;
        const CancelFlag& cancelled_;
        std::vector<Found> fresh_;
    };

    RunErrand() = default;
    /// Cancels, and waits until the threads have ended.
    ~RunErrand() {
        drop();
        // Cancel all threads before joining the first.
        dropped_.clear();
    }
    RunErrand(const RunErrand&) = delete;
    RunErrand& operator=(const RunErrand&) = delete;

    /// Starts `work`, which may use nothing that it may outlive. A job in progress is cancelled.
    void begin(std::function<void(Basket&)> work) {
        drop();
        job_ = std::make_unique<Job>();
        job_->thread.emplace([&job = *job_, work = std::move(work)](const CancelFlag& cancelled) {
            const Status good = guarded([&] {
                Basket basket(job, cancelled);
                work(basket);
                basket.report(1.0);
            });
            if (!good) job.complaint = good.error().message;
        });
    }
    void drop() {
        std::erase_if(dropped_, [](const auto& job) { return job->thread->ended(); });
        if (!job_) return;
        job_->thread->cancel();
        dropped_.push_back(std::move(job_));
    }

    bool busy() const { return job_ != nullptr; }
    /// In [0, 1], while busy.
    double share() const { return job_ ? job_->share.load() : 0.0; }
    /// Results since the last call, in order.
    std::vector<Found> take() {
        const std::lock_guard lock(job_->mutex);
        return std::exchange(job_->handed, {});
    }
    /// The job is complete; to be checked before take(), then close().
    bool ended() const { return job_ && job_->thread->ended(); }
    /// Once ended(): the text of the exception that ended the work; empty if there was none.
    const std::string& complaint() const { return job_->complaint; }
    void close() { job_.reset(); }
    /// Blocks until the job is complete.
    void wait() {
        if (job_) job_->thread->waitUntilDone();
    }

  private:
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> dropped_;  ///< Until they have ended.
};

}  // namespace se::view
