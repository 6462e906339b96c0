/// Runs a model once from start to end, in the background, and notes what there is to see from
/// afar: every decision is counted, none is kept.
#pragma once

#include <memory>
#include <string>

#include "background_job.h"
#include "run/model.h"
#include "run/overview.h"

namespace se::view {

class OverviewJob {
  public:
    explicit OverviewJob(std::shared_ptr<const Model> model);

    /// Appends what is new to `overview`. True if anything was.
    bool poll(RunOverview& overview);
    /// The run has ended, or was stopped.
    bool done() const { return job_.ended(); }
    /// Once done(): a sentence why the run ended early, once; empty if it was complete.
    std::string takeComplaint();
    /// Blocks until the run is complete.
    void waitUntilDone() { job_.waitUntilDone(); }

  private:
    std::size_t points_;        ///< Of the model.
    bool hasComplaint_ = true;  ///< Not taken yet.
    BackgroundJob<RunOverview> job_;
};

}  // namespace se::view
