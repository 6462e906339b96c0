/// What sampled points (sampler.h) are judged by.
#pragma once

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

struct Field;

/// How even particles are, and how near to the surface.
struct SampleQuality {
    double spacing = 0.0;    ///< Mean distance of a point inside to its nearest; 0: there is none.
    double variation = 0.0;  ///< Standard deviation of that over the mean.
    double off = 0.0;        ///< The largest distance to the surface, in spacings.
};
/// Of points with normals and types, as Sampler::points() has them. Boundary points do not count
/// for spacing and variation. All 0 if cancelled.
SampleQuality measureSample(const Field& field, const PointFile& points,
                            const Progress& progress = {});

}  // namespace se
