/// Trials: runs of the same points with other settings, each judged by its mesh, to find the
/// settings that suit a scan.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/mesh/mesh_verdict.h"
#include "spiraling_edge/spec/spec_fields.h"

namespace se {

/// A run with changed settings.
struct Trial {
    SpecChange change;
    /// PrepareOptions::leaveOut of the run: with the points of SpecChange::drop, ascending.
    std::vector<Index> leaveOut;
    MeshVerdict verdict;
    std::uint64_t work = 0;  ///< Pivots, and changes made by the repair.
    /// The mesh, kept of the first trial and of the best; null for all others.
    std::shared_ptr<const std::vector<Triangle>> mesh = nullptr;
};

/// The trial of a change as work in progress: "trying robust rules".
std::string trialText(const SpecChange& next);

/// Trials in the order in which they were made.
struct Trials {
    std::vector<Trial> tried;  ///< The first is that without a change.
    std::size_t best = 0;      ///< Position of the best one; 0: none is better than the first.
};

/// Maximum number of runs of tryChanges(), the run without a change included.
inline constexpr std::size_t kMaxTrials = 20;
/// Number of points above which trials are made only at the user's request.
inline constexpr std::size_t kManyForTrials = 300'000;

/// "more edges of holes (222, before 39)": the counts in which a mesh is worse than another of the
/// same points; empty if in none.
std::string lossesText(const MeshVerdict& mesh, const MeshVerdict& before);
/// "sound; 0 of 2 openings closed; distances up to 0.4, mean 0.01": headlineOf() and what else is
/// compared, in the unit of the points.
std::string describe(const MeshVerdict& verdict);

/// Both changes in one; nothing if they set the same field to two values.
std::optional<SpecChange> bothOf(const SpecChange& a, const SpecChange& b);

/// "No better settings among 5 changes tried." Requires a trial.
std::string noneBetterText(const Trials& trials);

/// The trial of `file` by these settings, without a change. Fails as tryChanges() does.
Result<Trial> trialOfRun(const PointFile& file, const RunSpec& spec, const Progress& progress = {});

/// Runs `file` with the settings `present` and with changes of them, a fixed list in a fixed order:
/// sets of rules, normals (oriented where given ones fit but contradict each other, derived where
/// they do not fit: given_normals.h; all meshes are judged by judgeFor() of the file), rims, points
/// that the doctor would drop, lengths of lists, single rules, and the best of these two at a time.
/// Ends early after a sound mesh that is worse than none in any count. Calls `visit`, unless it is
/// empty, before each trial, with all trials so far and the change to be tried. Fails if the
/// settings do not exist, if the points cannot be prepared, or if cancelled, which is checked
/// between the parts of a trial. Deterministic: equal input and settings give equal trials.
Result<Trials> tryChanges(const PointFile& file, const RunSpec& present,
                          const std::function<void(const Trials&, const SpecChange&)>& visit = {},
                          const Progress& progress = {});

}  // namespace se
