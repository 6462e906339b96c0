/// Titles of two views that are compared.
#pragma once

#include <array>

#include "comparison.h"

namespace se::view {

/// Titles of the open run and of what it is compared with; `now`: null if nothing can be.
std::array<ComparedTitle, 2> comparedTitles(const Session& run, const Comparison* now);

}  // namespace se::view
