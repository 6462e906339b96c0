/// A surface as given on the command line: a shape by its name, or the file of a volume.
#pragma once

#include <optional>
#include <string>

#include "progress.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/points/wall_types.h"
#include "spiraling_edge/sampling/sampler.h"

namespace se::cli {

/// Field of the surface, at `isovalue` or at its own. Throws Failure without field or isovalue.
Field readSurface(const std::string& input, const std::optional<double>& isovalue,
                  const ByteLimit& limit);

/// Makes `box` the domain. Throws Failure if a volume, whose name begins messages, is smaller.
void cutBy(const WallBox& box, const std::string& input, Field& field);

/// Samples with the progress line. Throws Failure if sampling fails.
PointFile samplePoints(const Field& field, const SamplerOptions& options, const std::string& input,
                       ProgressLine& line);

}  // namespace se::cli
