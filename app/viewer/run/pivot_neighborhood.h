/// The points that the decisions of a pivot are about.
#pragma once

#include <vector>

#include "picture.h"

namespace se::view {

/// The pivot, its ends, the candidates that are left, and what else the event at the cursor names;
/// in order, none twice. Where there is no pivot: the point under test, if there is one.
std::vector<Index> surroundingsOf(const Picture& picture);

}  // namespace se::view
