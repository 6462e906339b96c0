/// Values of the watched expressions over the whole run, computed by one run in a thread of its own
/// for all new expressions.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "background_job.h"
#include "run/model.h"
#include "spiraling_edge/run/watch.h"

namespace se::view {

/// A watched number, pivot by pivot.
struct WatchSeries {
    std::vector<double> values;  ///< [pivot], from 0, the start; computed so far.
    bool complete = false;
};

class WatchScan {
  public:
    /// Sets another run, of which nothing is known.
    void open(std::shared_ptr<const Model> model);
    /// Sets the expressions. Cheap if nothing is new.
    void want(std::span<const std::string> expressions);
    /// Takes the results. True if there was anything new.
    bool poll();
    /// Blocks until all wanted values are known.
    void waitUntilDone();
    /// Cancels, until something else is wanted or resume() is called. Known values stay.
    void cancel();
    void resume();

    /// Cancelled before all was known, or ended by a failure.
    bool cancelled() const { return givenUp_; }
    /// Why a scan failed: a sentence, once; empty if none has failed since.
    std::string takeComplaint() { return std::exchange(complaint_, {}); }
    bool busy() const { return job_.busy(); }
    double share() const { return job_.share(); }
    /// Null if the expression is not understood.
    const WatchSeries* of(const std::string& expression) const;

  private:
    struct Values {
        std::uint32_t pivot;
        std::vector<double> values;  ///< One for each expression in progress.
    };
    void startNext();

    std::shared_ptr<const Model> model_;
    std::vector<std::string> wanted_;
    std::map<std::string, WatchSeries> known_;
    bool givenUp_ = false;
    std::string complaint_;
    std::vector<std::string> sought_;  ///< Current scan.
    BackgroundJob<Values> job_;
};

}  // namespace se::view
