/// Inputs of the benchmarks, of the size of the paper's largest set.
#pragma once

#include "spiraling_edge/io/read_points.h"

namespace se::bench {

/// Even points on the unit sphere, on a spiral from pole to pole.
PointFile sphere(std::size_t count);
/// Points on a torus of radii 1 and 0.4, on a helix around its tube.
PointFile torus(std::size_t count);

/// The same points in an order by chance, the same one on every machine.
PointFile shuffled(PointFile file);

}  // namespace se::bench
