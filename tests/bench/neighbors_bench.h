/// The search for neighbor lists beside that of nanoflann, a k-d tree.
#pragma once

#include <functional>
#include <string>

#include "spiraling_edge/io/read_points.h"

namespace se::bench {

/// Rows neighbors/NAME and baseline_neighbors/NAME, on one thread; seconds for a million points are
/// microseconds for one.
void registerNeighbors(const std::string& name, const std::function<const PointFile&()>& points);

/// Rows of the files among the arguments, which are removed. The new number of arguments.
int registerNeighborsOfFiles(int argc, char** argv);

}  // namespace se::bench
