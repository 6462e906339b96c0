/// A query about the run that takes a while: a background job with a single result, the answer. A
/// new query cancels the previous one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "background_job.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::view {

template <typename Answer>
class BackgroundQuery {
  public:
    /// Returns an error once `progress` returns false. It must own all that it needs.
    using Work = std::function<Result<Answer>(const Progress& progress)>;

    /// Starts a query; the previous one is cancelled and its answer discarded.
    void start(Work work) {
        cancel();
        job_.start([work = std::move(work)](Results& results) {
            results.add(work([&results](double share) { return results.report(share); }));
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
        for (Result<Answer>& found : job_.take()) {
            if (found.ok()) {
                answer_ = std::move(found.value());
            } else {
                complaint_ = found.error().message;
            }
        }
        if (!job_.complaint().empty()) complaint_ = job_.complaint();
        job_.close();
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
