/// The triangles that a step after the last pivot made.
#pragma once

#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Triangles of `after` that `before` lacks, regardless of the first corner. Fast where few entries
/// of the lists differ.
std::vector<Triangle> freshTriangles(const std::vector<Triangle>& before,
                                     const std::vector<Triangle>& after);

}  // namespace se
