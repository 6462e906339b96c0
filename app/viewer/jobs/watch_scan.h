/// Values of the watched expressions over the whole run, computed by one run in a thread of its own
/// for all new expressions.
#pragma once

#include <string>
#include <vector>

#include "kept_pass.h"
#include "run/model.h"
#include "spiraling_edge/run/watch.h"

namespace se::view {

/// A watched number, pivot by pivot.
struct WatchSeries {
    std::vector<double> values;  ///< [pivot], from 0, the start; computed so far.
    bool complete = false;
};

/// Values of one pivot, one for each expression in progress.
struct WatchValues {
    std::uint32_t pivot;
    std::vector<double> values;
};

/// Known values stay if a scan is cancelled.
class WatchScan : public KeptPass<std::string, WatchSeries, WatchValues> {
  public:
    bool poll() override;
    void cancel() override;

  private:
    void startNext() override;

    std::vector<std::string> sought_;  ///< Current scan.
};

}  // namespace se::view
