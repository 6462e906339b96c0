/// Quality measures of sampled points (sampler.h).
#pragma once

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

struct Field;

/// Evenness of particles, and their distance to the surface.
struct SampleQuality {
    double spacing = 0.0;  ///< Mean distance of an interior point to its nearest; 0: there is none.
    double variation = 0.0;  ///< Standard deviation of that distance over the mean.
    double off = 0.0;        ///< The largest distance to the surface, in spacings.
};
/// The quality of points with normals and types, as from Sampler::points(). Boundary points do not
/// count for spacing and variation. All 0 if cancelled.
SampleQuality measureSample(const Field& field, const PointFile& points,
                            const Progress& progress = {});

}  // namespace se
