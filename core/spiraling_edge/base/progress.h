/// How long work reports, and how it is cancelled.
#pragma once

#include <functional>

namespace se {

/// Called now and then during long work with the share done in [0, 1]; returning false cancels.
using Progress = std::function<bool(double)>;

}  // namespace se
