/// A thread that goes through a run by itself and hands over what it finds, piece by piece. What is
/// dropped is left to itself; nobody waits for it.
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
        std::string complaint;         ///< Valid once it has ended.
        std::optional<Thread> thread;  // last: it uses all of the above
    };

  public:
    /// What the work gives its finds to.
    class Basket {
      public:
        Basket(Job& job, const CancelFlag& cancelled) : job_(job), cancelled_(cancelled) {}
        void add(Found found) { fresh_.push_back(std::move(found)); }
        /// Hands over; to be called now and then. False if nobody wants more of it.
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
    /// Cancels, and waits until the threads have noticed.
    ~RunErrand() {
        drop();
        // All know of it before the first is waited for.
        dropped_.clear();
    }
    RunErrand(const RunErrand&) = delete;
    RunErrand& operator=(const RunErrand&) = delete;

    /// `work` may use nothing that does not outlive it. What was under way is dropped.
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
    /// What was found since the last call, in the order in which it was.
    std::vector<Found> take() {
        const std::lock_guard lock(job_->mutex);
        return std::exchange(job_->handed, {});
    }
    /// All is found; to be asked before take(), then close().
    bool ended() const { return job_ && job_->thread->ended(); }
    /// Once ended(): the sentence of the exception that the work ended with; empty if with none.
    const std::string& complaint() const { return job_->complaint; }
    void close() { job_.reset(); }
    /// Blocks until all is found.
    void wait() {
        if (job_) job_->thread->waitUntilDone();
    }

  private:
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> dropped_;  ///< Until they have noticed.
};

}  // namespace se::view
