/// The points by which a mesh is judged: as they were given, whatever a run has made of them. So a
/// run and a later check of its mesh beside the points count the same faults.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/prepare/prepare.h"

namespace se {

/// The given points as a judge of meshes.
struct MeshJudge {
    /// With positions and types of the file, or of the walls of the options, never derived rims.
    /// Normals are those of the file if they fit (normalsFit()), where patches contradict each
    /// other (sidesOf()) the flipped ones turned; else derived ones. Without lists.
    std::shared_ptr<const PointSet> points;
    /// Points that a run with these normals sets aside as noise; in `points` they are not.
    std::vector<bool> noise{};
    bool fit = false;           ///< The file has normals, and they fit.
    std::size_t flipped = 0;    ///< Of these, turned to the side of those around them.
    double unfitDegrees = 0.0;  ///< Median angle of given normals that do not fit; else 0.

    /// The points for a run, as it prepared them: noise that it set aside is not missing in its
    /// mesh, unless it is noise along wrong normals alone. Points of `leaveOut` are missing
    /// (PrepareOptions::leaveOut).
    std::shared_ptr<const PointSet> forRun(const PointSet& run,
                                           std::span<const Index> leaveOut = {}) const;
    /// Given normals fit and agree: nothing but the user's word turns them or derives others.
    bool areRight() const { return fit && flipped == 0; }
};
/// How the judge departs from the given normals, as a piece of a sentence: "by derived normals: the
/// given ones are 40 degrees off the surface (median)"; empty if it does not.
std::string departureText(const MeshJudge& judge);

/// The judge of meshes of a file's points. Of `options` count the walls, the number of threads, and
/// that the user has the sides of normals derived (`normals`, `scanner`): then a piece of points
/// whose shape does not say that its given normals face outward may face as in `run`, the points
/// prepared with these options. Fails as prepare() does. Deterministic. O(points log points).
Result<MeshJudge> judgeFor(const PointFile& file, const PrepareOptions& options,
                           const PointSet& run, const Progress& progress = {});
/// As above, of points whose sides are not derived at the user's word.
Result<MeshJudge> judgeFor(const PointFile& file, const std::optional<WallBox>& walls = {},
                           unsigned threads = 0, const Progress& progress = {});

}  // namespace se
