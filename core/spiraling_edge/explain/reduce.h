/// Shrinking an input to the fewest points that still fail.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

/// What is left of an input.
struct Reduced {
    PointFile file;
    std::vector<Index> kept;  ///< Numbers in the input, ascending.
    std::size_t tries = 0;    ///< How often it was tried whether the failure is still there.
    bool complete = true;     ///< False: the effort was used up, fewer points may do.
};

/// The outcome of one try.
struct ReduceTry {
    bool fails = false;
    std::uint64_t work = 0;  ///< What it took, in the unit of the effort.
};

/// Takes points out of `file` for as long as `fails` holds: first all but the ball about `place`
/// that still fails, then piece by piece and point by point (delta debugging, Zeller and
/// Hildebrandt 2002), until no single point can go. Fails if the whole input does not, or if
/// cancelled; the share of `progress` goes by the points left. Once the tries have taken `effort`
/// together, no more are made: the result is the best so far, maybe the whole input. `file` must be
/// as treat() leaves it. Deterministic if `fails` is.
Result<Reduced> reduceInput(const PointFile& file, const Vec3& place,
                            const std::function<ReduceTry(const PointFile&)>& fails,
                            std::uint64_t effort, const Progress& progress = {});
/// As above, for as long as it takes.
Result<Reduced> reduceInput(const PointFile& file, const Vec3& place,
                            const std::function<bool(const PointFile&)>& fails,
                            const Progress& progress = {});

}  // namespace se
