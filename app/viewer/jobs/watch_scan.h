/// The values of what a person watches, over the whole run: got by one run in a thread of its own
/// for all expressions that are new.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "background_job.h"
#include "run/model.h"
#include "spiraling_edge/replay/watch.h"

namespace se::view {

/// A watched number, pivot by pivot.
struct WatchSeries {
    std::vector<double> values;  ///< [pivot], from 0, the start; as far as is known.
    bool complete = false;
};

class WatchScan {
  public:
    /// Another run: nothing is known of it.
    void open(std::shared_ptr<const Model> model);
    /// The expressions there are. Cheap if nothing is new.
    void want(std::span<const std::string> expressions);
    /// Takes over what was found. True if that is news.
    bool poll();
    /// Blocks until everything that is wanted is known.
    void finish();
    /// Gives up, until something else is wanted or resume() is called. What is known stays.
    void cancel();
    void resume();

    /// Given up by cancel() before all was known, or because the scan failed.
    bool cancelled() const { return givenUp_; }
    /// Why a scan failed: a sentence, once; empty if none has failed since.
    std::string takeComplaint() { return std::exchange(complaint_, {}); }
    bool busy() const { return errand_.busy(); }
    double share() const { return errand_.share(); }
    /// Null if the expression is not understood.
    const WatchSeries* of(const std::string& expression) const;

  private:
    struct Values {
        std::uint32_t pivot;
        std::vector<double> values;  ///< One for each that is sought.
    };
    void beginNext();

    std::shared_ptr<const Model> model_;
    std::vector<std::string> wanted_;
    std::map<std::string, WatchSeries> known_;
    bool givenUp_ = false;
    std::string complaint_;
    std::vector<std::string> sought_;  ///< What is under way.
    RunErrand<Values> errand_;
};

}  // namespace se::view
