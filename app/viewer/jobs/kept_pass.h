/// Passes through the run for what is wanted, each for all that is not known yet. What is known is
/// kept until another run is open.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "background_job.h"
#include "run/model.h"

namespace se::view {

/// `Known`: what is known of a text, such as the line of a breakpoint.
template <typename Wanted, typename Known, typename Found>
class KeptPass {
  public:
    KeptPass() = default;
    virtual ~KeptPass() = default;
    KeptPass(const KeptPass&) = delete;
    KeptPass& operator=(const KeptPass&) = delete;

    /// Sets another run, of which nothing is known.
    void open(std::shared_ptr<const Model> model) {
        job_.cancel();
        model_ = std::move(model);
        known_.clear();
        resume();
    }
    /// Sets what is wanted. Cheap if nothing is new.
    void want(std::span<const Wanted> wanted) {
        if (std::equal(wanted_.begin(), wanted_.end(), wanted.begin(), wanted.end())) return;
        wanted_.assign(wanted.begin(), wanted.end());
        resume();
    }
    const std::vector<Wanted>& wanted() const { return wanted_; }
    /// Takes the results. True if there was anything new.
    virtual bool poll() = 0;
    /// Blocks until all that is wanted is known.
    void waitUntilDone() {
        while (busy()) {
            job_.waitUntilDone();
            poll();
        }
    }
    /// Cancels the pass, until something else is wanted or resume() is called.
    virtual void cancel() = 0;
    void resume() {
        givenUp_ = false;
        if (model_) startNext();
    }

    bool busy() const { return job_.busy(); }
    /// In [0, 1], while busy.
    double share() const { return job_.share(); }
    /// Cancelled before all was known, or ended by a failure.
    bool cancelled() const { return givenUp_; }
    /// Why a pass failed: a sentence, once; empty if none has failed since.
    std::string takeComplaint() { return std::exchange(complaint_, {}); }
    /// Null if the text was never wanted, or is not understood.
    const Known* of(const std::string& text) const {
        const auto found = known_.find(text);
        return found == known_.end() ? nullptr : &found->second;
    }

  protected:
    /// Begins a pass for what is missing, if anything is.
    virtual void startNext() = 0;

    std::shared_ptr<const Model> model_;
    std::vector<Wanted> wanted_;
    std::map<std::string, Known> known_;
    bool givenUp_ = false;
    std::string complaint_;
    BackgroundJob<Found> job_;
};

}  // namespace se::view
