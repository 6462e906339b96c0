/// One question about the run that takes a while: answered in a thread of its own, with progress,
/// and given up as soon as another is asked.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "spiraling_edge/prepare.h"
#include "spiraling_edge/result.h"

namespace se::view {

template <typename Answer>
class Inquiry {
  public:
    /// Returns an error once `progress` says no. It must hold all that it needs.
    using Work = std::function<Result<Answer>(const Progress& progress)>;

    Inquiry() = default;
    /// Cancels, and waits until the threads have noticed.
    ~Inquiry() {
        leave();
        left_.clear();
    }
    Inquiry(const Inquiry&) = delete;
    Inquiry& operator=(const Inquiry&) = delete;

    /// What was asked before is given up, its answer forgotten.
    void ask(Work work) {
        forget();
        job_ = std::make_unique<Job>();
        job_->thread = std::jthread([&job = *job_, work = std::move(work)] {
            job.answer = work([&job](double share) {
                job.share = share;
                return !job.cancelled.load();
            });
            job.ended = true;
        });
    }
    /// No question, no answer.
    void forget() {
        leave();
        answer_.reset();
        complaint_.clear();
    }
    /// As a person wishes: complaint() says so.
    void stop() {
        if (!busy()) return;
        leave();
        complaint_ = "Stopped.";
    }
    /// Takes over what was found. True if that is news.
    bool poll() {
        if (!busy() || !job_->ended) return false;
        finish();
        if (job_->answer->ok()) {
            answer_ = std::move(job_->answer->value());
        } else {
            complaint_ = job_->answer->error().message;
        }
        job_.reset();
        return true;
    }
    /// Blocks until there is something to take over, or nothing was asked.
    void finish() {
        if (busy() && job_->thread.joinable()) job_->thread.join();
    }

    bool busy() const { return job_ != nullptr; }
    /// In [0, 1], while busy.
    double share() const { return job_ ? job_->share.load() : 0.0; }
    /// Null before there is one.
    const Answer* answer() const { return answer_ ? &*answer_ : nullptr; }
    /// Why there is none, as a sentence; empty if nothing went wrong.
    const std::string& complaint() const { return complaint_; }

  private:
    struct Job {
        std::optional<Result<Answer>> answer;
        std::atomic<double> share = 0.0;
        std::atomic<bool> cancelled = false;
        std::atomic<bool> ended = false;
        std::jthread thread;  // last: it uses all of the above
    };
    /// Leaves the job under way to itself.
    void leave() {
        std::erase_if(left_, [](const auto& job) { return job->ended.load(); });
        if (!job_) return;
        job_->cancelled = true;
        left_.push_back(std::move(job_));
    }

    std::optional<Answer> answer_;
    std::string complaint_;
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> left_;  ///< Cancelled, until they have noticed.
};

}  // namespace se::view
