/// Trials of other settings for the open input (core's trial.h), in a thread of low priority.
#pragma once

#include <memory>
#include <string>

#include "background_job.h"
#include "run/repair_diff.h"
#include "spiraling_edge/why/trial.h"

namespace se::view {

class TrialJob {
  public:
    /// Sets the input to try, prepared by `spec`; trials in progress are cancelled.
    void open(std::shared_ptr<const PointFile> file, RunSpec spec);
    /// Starts the trials, unless they were started.
    void start();
    /// Ends them at the user's request; what was tried stays.
    void stop();
    /// Takes the results. True if there was anything new.
    bool poll();
    /// Blocks until all trials are made, or none are in progress.
    void waitUntilDone() { job_.waitUntilDone(); }

    bool busy() const { return job_.busy(); }
    /// All trials were made, or the user has ended them.
    bool ended() const { return started_ && !busy(); }
    /// In [0, 1], while busy.
    double share() const { return job_.share(); }
    /// Trials so far.
    const Trials& trials() const { return trials_; }
    /// The best of them; null if none is better than the open run.
    const Trial* best() const { return trials_.best > 0 ? &trials_.tried[trials_.best] : nullptr; }
    /// The triangles in which the mesh of best() differs from that of the open run; null if there
    /// is no best().
    const MeshChange* change() const { return change_.get(); }
    /// A sentence why the trials ended early; empty if they did not.
    const std::string& complaint() const { return complaint_; }
    /// The trial in progress: "trying robust rules".
    const std::string& trying() const { return trying_; }

  private:
    struct Progressed {
        Trials trials;
        std::string next;
        std::shared_ptr<const MeshChange> change = nullptr;
        std::string complaint = {};
    };

    std::shared_ptr<const PointFile> file_;
    RunSpec spec_;
    bool started_ = false;
    Trials trials_;
    std::string trying_;
    std::shared_ptr<const MeshChange> change_;
    std::string complaint_;
    BackgroundJob<Progressed> job_;
};

}  // namespace se::view
