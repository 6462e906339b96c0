/// The doctor's examination of the open input, in a thread of its own (core's doctor.h).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "background_job.h"
#include "run/model.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se::view {

class DoctorJob : public BackgroundQuery<Diagnosis> {
  public:
    /// Sets the input to examine, which starts at start(); an examination in progress is cancelled.
    void enqueue(std::shared_ptr<const PointFile> file);
    /// Starts the examination, unless it was done.
    void start();
    /// Tries the commands of the findings, in a thread (tried_fixes.h); not on many points.
    /// Requires done().
    void tryFixes();
    /// Takes their effects. True if there was anything new.
    bool pollFixes() { return fixes_.poll(); }
    /// Blocks until the examination, or what tryFixes() started, is complete.
    void waitUntilDone() {
        BackgroundQuery::waitUntilDone();
        fixes_.waitUntilDone();
    }
    bool done() const { return answer() != nullptr; }
    /// Empty before the examination is done; with Finding::tried once all were tried.
    std::span<const Finding> findings() const {
        if (!done()) return {};
        return fixes_.answer() != nullptr ? fixes_.answer()->findings : answer()->findings;
    }

    /// The record of the input. Requires done().
    const InputFacts& facts() const { return answer()->facts; }

  private:
    std::shared_ptr<const PointFile> file_;      ///< Null once it is examined.
    std::shared_ptr<const PointFile> examined_;  ///< Null before.
    BackgroundQuery<Diagnosis> fixes_;
};

/// Points of a finding that are highlighted: all, or evenly chosen ones if there are more than
/// `limit`; none that cannot be drawn.
std::vector<Index> pointsToMark(const Model& model, const Finding& finding,
                                std::size_t limit = 2000);

}  // namespace se::view
