/// The doctor's advice, tried: the command that helps with a finding is carried out on the file in
/// memory, and its effect is reported beside it.
#pragma once

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se {

/// Number of points above which fixes are tried only at the user's request.
inline constexpr std::size_t kManyForFixes = 20'000;
/// Work after which no further command is tried but at the user's request: pivots and changes made
/// by the repair, or points if there are more, and faults of all runs. About five seconds.
inline constexpr std::uint64_t kWorkOfFixes = 250'000;

/// Tries the commands of all findings, each command once, the dearest last, and sets
/// Finding::tried; not of commands that would take more than `work` together. A command that
/// repairs or drops points writes a new file, so each of the two meshes is judged by the points of
/// its own file. The runs are by `paper`, as the command `run` makes them, and by `robust`; the
/// command with --best is tryChanges(). A fix helps if by one of these sets the mesh is sounder
/// (isSounder()), and by none less so, or if one mesh is sound and none was before. Fails if
/// cancelled. Deterministic.
Status tryFixes(const PointFile& file, Diagnosis& diagnosis, const Progress& progress = {},
                std::uint64_t work = kWorkOfFixes);

}  // namespace se
