/// The points that the decisions of a pivot involve.
#pragma once

#include <vector>

#include "picture.h"

namespace se::view {

/// The pivot, its ends, the candidates that are left, and other points named by the event at the
/// cursor; in order, none twice. Without a pivot: the point under test, if there is one.
std::vector<Index> neighborhoodOf(const Picture& picture);

}  // namespace se::view
