/// The points by which a mesh is judged: as they were given, whatever a run has made of them. So a
/// run and a later check of its mesh beside the points count the same faults.
#pragma once

#include <memory>
#include <optional>

#include "spiraling_edge/mesh/mesh_judge.h"
#include "spiraling_edge/prepare/given_normals.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// A file's points as they were taken in: what is known of them before any run, and the measures
/// that it was found with.
struct Intake {
    PlacedPoints placed;        ///< By positions alone.
    std::vector<bool> present;  ///< The points that are usable.
    NeighborLists nearest;      ///< The 12 nearest of these, with any normals.
    std::vector<Vec3> normal;   ///< As given, scaled; zero without direction. Empty if none.
    NormalFit fit;              ///< Of the given normals to the planes of the points.
    std::shared_ptr<const MeshJudge> judge;  ///< With InputFacts.
};
/// Fails as prepare() does. Deterministic. O(points log points).
Result<Intake> takeIn(const PointFile& file, const Progress& progress = {});

/// The judge of the meshes of a run with `params`. Of `options` only these count: the walls, the
/// number of threads, and whether the user has the sides of normals derived (`normals`, `scanner`).
/// If so, a piece of points whose shape does not say that its given normals face outward may face
/// as in `run`, the points of `file` prepared with these options. Openings within
/// Params::isWithinHoleLimits() are left out: the run closes them. Fails as prepare() does.
/// Deterministic. O(points log points).
Result<std::shared_ptr<const MeshJudge>> judgeOfRun(const PointFile& file,
                                                    const PrepareOptions& options,
                                                    const Params& params, const PointSet& run,
                                                    const Progress& progress = {});
/// The judge of a file without options but the number of threads, as in NeighborOptions.
Result<std::shared_ptr<const MeshJudge>> judgeFor(const PointFile& file, unsigned threads = 0);
/// The points of a mesh without others to judge it by: its own, as they are.
PointSet ownPoints(const PointFile& mesh);

}  // namespace se
