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
/// Finding::tried; not of commands that would take more than `work` together. Points that are
/// repaired or dropped are a new file, as the command writes it; so is each side judged by its own
/// points. The runs are by `paper`, as run makes them, and by `robust`; the command with --best is
/// tryChanges(). A fix helps if by one of them the mesh has fewer faults, and by none more, or if
/// one is sound and none was. Fails if cancelled. Deterministic.
Status tryFixes(const PointFile& file, Diagnosis& diagnosis, const Progress& progress = {},
                std::uint64_t work = kWorkOfFixes);

}  // namespace se
