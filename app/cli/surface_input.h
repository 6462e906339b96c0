/// A surface as it stands on the command line: a shape by its name, or the file of a volume.
#pragma once

#include <optional>
#include <string>

#include "progress.h"
#include "spiraling_edge/points/wall_types.h"
#include "spiraling_edge/sampling/sampler.h"

namespace se::cli {

/// The field of it, at `isovalue` or at its own. Throws Failure if there is none, or no isovalue.
Field readSurface(const std::string& input, const std::optional<double>& isovalue);

/// Makes `box` the domain. Throws Failure if a volume, whose name begins messages, ends before.
void cutBy(const WallBox& box, const std::string& input, Field& field);

/// Samples with the line of progress. Throws Failure if that fails or is interrupted.
PointFile samplePoints(const Field& field, const SamplerOptions& options, const std::string& input,
                       ProgressLine& line);

}  // namespace se::cli
