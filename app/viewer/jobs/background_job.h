/// Work in the background, in slices (thread.h). A background job streams its results to the
/// caller; a background query has a single result, the answer. What is cancelled finishes in the
/// background.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "run/model.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/run/sweep.h"
#include "thread.h"

namespace se::view {

template <typename Item>
class BackgroundJob {
  public:
    class Results;

  private:
    struct Job {
        std::mutex mutex;
        std::vector<Item> pending;  ///< Not yet taken; guarded.
        std::atomic<double> share = 0.0;
        std::string complaint;           ///< Valid once the job has ended.
        std::optional<Results> results;  ///< Of the work, from its first slice on.
        std::optional<Thread> thread;    // last: it uses all members above
    };

  public:
    /// Collector of the results of the work.
    class Results {
      public:
        Results(Job& job, const CancelFlag& cancelled) : job_(job), cancelled_(cancelled) {}
        void add(Item item) { fresh_.push_back(std::move(item)); }
        /// Delivers the results; to be called now and then. False if the job was cancelled.
        bool report(double share) {
            job_.share = share;
            const std::lock_guard lock(job_.mutex);
            std::move(fresh_.begin(), fresh_.end(), std::back_inserter(job_.pending));
            fresh_.clear();
            return !cancelled_.isSet();
        }

      private:
        Job& job_;
        const CancelFlag& cancelled_;
        std::vector<Item> fresh_;
    };

    BackgroundJob() = default;
    /// Cancels, and waits until the threads have ended.
    ~BackgroundJob() {
        cancel();
        // Cancel all threads before joining the first.
        cancelled_.clear();
    }
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;

    /// Starts `work`, which may use nothing that it may outlive. A job in progress is cancelled.
    void start(std::function<void(Results&)> work) {
        startSlices([work = std::move(work)](Results& results) {
            work(results);
            return false;
        });
    }
    /// Starts work in slices: `slice` is called until it or report() returns false. It should take
    /// no longer than sliceTime().
    void startSlices(std::function<bool(Results&)> slice) {
        cancel();
        job_ = std::make_unique<Job>();
        job_->thread.emplace([&job = *job_, slice = std::move(slice)](const CancelFlag& cancelled) {
            bool more = false;
            const Status good = guarded([&] {
                if (!job.results) job.results.emplace(job, cancelled);
                more = slice(*job.results) && !cancelled.isSet();
                if (!more) job.results->report(1.0);
            });
            if (!good) job.complaint = good.error().message;
            return more && good ? Slice::More : Slice::Done;
        });
    }
    /// Starts a pass through the run of a model. `make` returns its visitor, in the first slice: to
    /// begin may take a pass over the points.
    void startPass(std::shared_ptr<const Model> model,
                   std::function<PivotVisitor(const Model&, Results&)> make) {
        startSlices([model = std::move(model), make = std::move(make),
                     pass = std::shared_ptr<Sweep>()](Results& results) mutable {
            if (!pass)
                pass = std::make_shared<Sweep>(model->points, model->params, make(*model, results));
            const bool more = pass->advance(kPivotsPerReport);
            return results.report(pass->share()) && more;
        });
    }
    void cancel() {
        std::erase_if(cancelled_, [](const auto& job) { return job->thread->ended(); });
        if (!job_) return;
        job_->thread->cancel();
        if (!job_->thread->ended()) cancelled_.push_back(std::move(job_));
        job_.reset();
    }

    bool busy() const { return job_ != nullptr; }
    /// In [0, 1], while busy.
    double share() const { return job_ ? job_->share.load() : 0.0; }
    /// The job is complete, and waits for take().
    bool ended() const { return job_ && job_->thread->ended(); }
    /// The results since the last call of take().
    struct Taken {
        std::vector<Item> items;  ///< In order.
        bool ended = false;       ///< No more will come.
        std::string complaint;    ///< Text of the exception that ended it; empty: none has.

        bool any() const { return ended || !items.empty(); }
    };
    /// Takes the results, and closes the job if it is complete.
    Taken take() {
        if (!job_) return {};
        // Asked first: results may come until then.
        const bool ended = this->ended();
        Taken taken{{}, ended, ended ? job_->complaint : std::string{}};
        {
            const std::lock_guard lock(job_->mutex);
            taken.items.swap(job_->pending);
        }
        if (ended) job_.reset();
        return taken;
    }
    /// Blocks until the job is complete, at most for `timeout`. True if it is.
    bool waitFor(std::chrono::milliseconds timeout) {
        return !job_ || job_->thread->waitFor(timeout);
    }
    /// Blocks until the job is complete.
    void waitUntilDone() {
        if (job_) job_->thread->waitUntilDone();
    }

  private:
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> cancelled_;  ///< Until they have ended.
};

/// A query about the run that takes a while. A new query cancels the previous one.
template <typename Answer>
class BackgroundQuery {
  public:
    /// Returns an error once `progress` returns false. It must own all that it needs.
    using Work = std::function<Result<Answer>(const Progress& progress)>;

    /// Starts a query that is a question about the run of a model, which `make` returns in the
    /// first slice; the previous one is cancelled and its answer discarded.
    void ask(std::shared_ptr<const Model> model,
             std::function<Question<Answer>(const Model&)> make) {
        cancel();
        job_.startSlices([model = std::move(model), make = std::move(make),
                          question = Question<Answer>(),
                          pass = std::shared_ptr<Sweep>()](Results& results) mutable {
            if (!pass) {
                question = make(*model);
                pass = std::make_shared<Sweep>(model->points, model->params, question.visit,
                                               question.wants);
            }
            const bool more = pass->advance(kPivotsPerReport);
            if (!more) results.add(question.answer(pass->state()));
            return results.report(pass->share()) && more;
        });
    }
    /// Starts a query; the previous one is cancelled and its answer discarded.
    void start(Work work) {
        cancel();
        job_.start([work = std::move(work)](Results& results) {
            results.add(work([&results](double share) { return results.report(share); }));
        });
    }
    /// A slice of the work of a query: sets its share, in [0, 1], and returns the answer at its
    /// end.
    using Slice = std::function<std::optional<Result<Answer>>(double& share)>;
    /// Starts a query in slices, which should take no longer than sliceTime(); the previous one is
    /// cancelled and its answer discarded.
    void startSlices(Slice slice) {
        cancel();
        job_.startSlices([slice = std::move(slice)](Results& results) {
            double share = 0.0;
            std::optional<Result<Answer>> answer = slice(share);
            const bool ended = answer.has_value();
            if (ended) results.add(std::move(*answer));
            return results.report(share) && !ended;
        });
    }
    /// Discards query and answer.
    void cancel() {
        job_.cancel();
        answer_.reset();
        complaint_.clear();
    }
    /// Stops at the user's request and sets complaint().
    void stop() {
        if (!busy()) return;
        job_.cancel();
        complaint_ = "Stopped.";
    }
    /// Takes the result. True if there was anything new.
    bool poll() {
        if (!job_.ended()) return false;
        auto taken = job_.take();
        for (Result<Answer>& found : taken.items) {
            if (found.ok()) {
                answer_ = std::move(found.value());
            } else {
                complaint_ = found.error().message;
            }
        }
        if (!taken.complaint.empty()) complaint_ = std::move(taken.complaint);
        return true;
    }
    /// Blocks until there is a result to take, or there is no query.
    void waitUntilDone() { job_.waitUntilDone(); }

    bool busy() const { return job_.busy(); }
    /// In [0, 1], while busy.
    double share() const { return job_.share(); }
    /// The answer, moved out; nothing before there is one.
    std::optional<Answer> takeAnswer() { return std::exchange(answer_, std::nullopt); }
    /// Null before there is an answer.
    const Answer* answer() const { return answer_ ? &*answer_ : nullptr; }
    /// A sentence why there is no answer; empty if nothing failed.
    const std::string& complaint() const { return complaint_; }

  private:
    using Results = typename BackgroundJob<Result<Answer>>::Results;

    std::optional<Answer> answer_;
    std::string complaint_;
    BackgroundJob<Result<Answer>> job_;
};

}  // namespace se::view
