/// One question about the run that takes a while: an errand with a single find, its answer. It is
/// given up as soon as another is asked.
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
class Inquiry {
  public:
    /// Returns an error once `progress` says no. It must hold all that it needs.
    using Work = std::function<Result<Answer>(const Progress& progress)>;

    /// What was asked before is given up, its answer forgotten.
    void ask(Work work) {
        forget();
        errand_.begin([work = std::move(work)](Basket& basket) {
            basket.add(work([&basket](double share) { return basket.report(share); }));
        });
    }
    /// No question, no answer.
    void forget() {
        errand_.drop();
        answer_.reset();
        complaint_.clear();
    }
    /// As a person wishes: complaint() says so.
    void stop() {
        if (!busy()) return;
        errand_.drop();
        complaint_ = "Stopped.";
    }
    /// Takes over what was found. True if that is news.
    bool poll() {
        if (!errand_.ended()) return false;
        for (Result<Answer>& found : errand_.take()) {
            if (found.ok()) {
                answer_ = std::move(found.value());
            } else {
                complaint_ = found.error().message;
            }
        }
        if (!errand_.complaint().empty()) complaint_ = errand_.complaint();
        errand_.close();
        return true;
    }
    /// Blocks until there is something to take over, or nothing was asked.
    void finish() { errand_.wait(); }

    bool busy() const { return errand_.busy(); }
    /// In [0, 1], while busy.
    double share() const { return errand_.share(); }
    /// The answer, moved out; nothing before there is one.
    std::optional<Answer> takeAnswer() { return std::exchange(answer_, std::nullopt); }
    /// Null before there is one.
    const Answer* answer() const { return answer_ ? &*answer_ : nullptr; }
    /// Why there is none, as a sentence; empty if nothing went wrong.
    const std::string& complaint() const { return complaint_; }

  private:
    using Basket = typename RunErrand<Result<Answer>>::Basket;

    std::optional<Answer> answer_;
    std::string complaint_;
    RunErrand<Result<Answer>> errand_;
};

}  // namespace se::view
