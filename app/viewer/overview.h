/// The whole run at a glance, for the strip under the view: made by a thread of its own that runs
/// once from start to end without a log.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "model.h"
#include "spiraling_edge/event.h"

namespace se::view {

/// Something on the way that is worth a mark.
enum class MarkKind : std::uint8_t { Seed, Split, Join, Alert };

/// The stage whose events tell of it.
Stage stageOf(MarkKind kind);

struct RunMark {
    std::uint32_t pivot;
    MarkKind kind;
};

/// One number per completed pivot; index 0 is the first pivot.
struct RunOverview {
    std::vector<std::uint32_t> ringLength;  ///< Of the active ring.
    std::vector<std::uint32_t> stackDepth;
    std::vector<std::uint32_t> triangles;  ///< So far.
    std::vector<RunMark> marks;
    std::uint32_t longestRing = 0;
    std::uint32_t deepestStack = 0;
    std::uint32_t lastPivot = 0;  ///< Of the whole run if complete, else the farthest so far.
    bool complete = false;
};

class OverviewThread {
  public:
    explicit OverviewThread(std::shared_ptr<const Model> model);

    /// Appends what is new to `overview`. True if anything was.
    bool update(RunOverview& overview);
    /// Blocks until the run is complete.
    void finish() {
        if (thread_.joinable()) thread_.join();
    }

  private:
    void work(const std::stop_token& stop);
    void hand(RunOverview& fresh);

    std::shared_ptr<const Model> model_;
    std::mutex mutex_;
    RunOverview fresh_;  ///< What update() has not yet taken.
    bool changed_ = false;
    std::jthread thread_;  // last: it uses all of the above
};

/// Puts the lists of `fresh` behind those of `overview` and takes over its figures.
void append(RunOverview& overview, const RunOverview& fresh);

}  // namespace se::view
