/// The verdict on a mesh as JSON, for every report that has one.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "spiraling_edge/mesh/mesh_verdict.h"

namespace se::cli {

/// All numbers of a verdict: whether the mesh is sound, its places by class, points in no triangle
/// by reason, the counts that are compared, and the distances of the points.
nlohmann::ordered_json verdictJson(const MeshVerdict& verdict);

}  // namespace se::cli
