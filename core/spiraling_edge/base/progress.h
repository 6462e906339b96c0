/// Progress reports and cancellation of long work.
#pragma once

#include <functional>

namespace se {

/// Called at intervals during long work with the share done in [0, 1]; returning false cancels.
using Progress = std::function<bool(double)>;

}  // namespace se
