/// Reduction of an input to a minimal failing case.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

/// A reduced input.
struct Reduced {
    PointFile file;
    std::vector<Index> kept;  ///< Numbers in the input, ascending.
    std::size_t tries = 0;    ///< Number of calls of `fails`.
    bool complete = true;     ///< False: the effort was used up; fewer points may fail, too.
};

/// The outcome of one try.
struct ReduceTry {
    bool fails = false;
    std::uint64_t work = 0;  ///< Cost of the try, in the unit of the effort.
};

/// Removes points from `file` while `fails` holds: first all but the ball about `place` that still
/// fails, then piece by piece and point by point (delta debugging, Zeller and Hildebrandt 2002),
/// until no single point can be removed. Fails if the whole input does not fail, or if cancelled;
/// `progress` gets a share by the points left. Once the tries have taken `effort` together, no more
/// are made: the result is the best so far, possibly the whole input; tries without work use up no
/// effort. `file` must come from
/// applyFixes(). Deterministic if `fails` is.
Result<Reduced> reduceInput(const PointFile& file, const Vec3& place,
                            const std::function<ReduceTry(const PointFile&)>& fails,
                            std::uint64_t effort, const Progress& progress = {});

/// True if the triangles of a failure are two with the same three points, apart from the rest of
/// the mesh: any three points alone give these, whatever failed before.
bool isBackToBack(const MeshFailure& failure, std::span<const Triangle> mesh);

}  // namespace se
