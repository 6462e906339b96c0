/// Trials: runs of the same points with other settings, each judged by its mesh, to find the
/// settings that suit a scan.
#pragma once

#include <functional>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/explain/run_settings.h"
#include "spiraling_edge/mesh/fidelity.h"
#include "spiraling_edge/mesh/inspection.h"

namespace se {

/// The mesh of a run in numbers. Points lost and set aside, openings and distances show what became
/// of the points, so that neither points that are left out nor openings that are closed can pass
/// for fewer faults.
struct MeshNumbers {
    std::size_t points = 0;    ///< All, used or not.
    std::size_t lost = 0;      ///< Points in no triangle, `dropped` ones too, without noise.
    std::size_t dropped = 0;   ///< Usable points of SettingsChange::drop.
    std::size_t setAside = 0;  ///< Usable points that were set aside: noise, and `dropped`.
    /// Openings of the scan: chains of findRim() over its points, with the lists of the run without
    /// a change; but for those within Params::isWithinHoleLimits(), which are to be closed.
    std::size_t openings = 0;
    std::size_t closed = 0;  ///< Of these, those that the mesh covers.
    Fidelity fidelity;       ///< Distances of all points from the mesh, of those set aside too.
    std::vector<ClassTotal> totals;  ///< One for each of failureClasses(), in its order.
    std::size_t triangles = 0;
    bool capped = false;  ///< The run was stopped: Params::maxTrianglesPerPoint.
};
/// "12 faults; 3 points lost; 1 of 2 openings closed; distances up to 0.4, mean 0.01", in the unit
/// of the points.
std::string describe(const MeshNumbers& numbers);
/// isSound() of the mesh of a run that was not stopped.
bool isSound(const MeshNumbers& numbers);

/// A run with changed settings.
struct Trial {
    SettingsChange change;
    /// PrepareOptions::leaveOut of the run: with the points of SettingsChange::drop, ascending.
    std::vector<Index> leaveOut;
    MeshNumbers numbers;
};

/// The trial of a change as work in progress: "trying rules of robust".
std::string trialText(const SettingsChange& next);

/// Trials in the order in which they were made.
struct Trials {
    std::vector<Trial> tried;  ///< The first is that without a change.
    std::size_t best = 0;      ///< Position of the best one; 0: none is better than the first.
};

/// Maximum number of runs of tryChanges(), the run without a change included.
inline constexpr std::size_t kMaxTrials = 20;
/// Number of points above which trials are made only at the user's request.
inline constexpr std::size_t kManyForTrials = 300'000;

/// True if `trial` is better than `best`, given the numbers `present` of the run without a change.
/// A run that was stopped is never better, nor is one that closes an opening more than `present`
/// does, or loses more than one point in 200 more, but for those that it drops. Then fewer faults
/// are better, lost points among them; then fewer points set aside, fewer lost, fewer openings
/// closed, a lesser greatest and a lesser mean distance.
bool isBetter(const MeshNumbers& trial, const MeshNumbers& best, const MeshNumbers& present);

/// Runs `file` with the settings `present` and with changes of them, a fixed list in a fixed order:
/// sets of rules, normals (oriented where given ones fit but contradict each other, derived where
/// they do not fit: given_normals.h; all meshes are judged by judgeFor() of the file), rims,
/// lengths of lists, single rules, points that the doctor would drop, and the best of these two at
/// a time. Ends early after a sound mesh that loses no point and closes no opening. Calls `visit`,
/// unless it is empty, before each trial, with all trials so far and the change to be tried. Fails
/// if the settings do not exist, if the points cannot be prepared, or if cancelled, which is
/// checked between the parts of a trial. Deterministic: equal input and settings give equal trials.
Result<Trials> tryChanges(
    const PointFile& file, const RunSettings& present,
    const std::function<void(const Trials&, const SettingsChange&)>& visit = {},
    const Progress& progress = {});

}  // namespace se
