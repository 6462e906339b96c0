/// The doctor's advice, tried: the command that helps with a finding is carried out on the file in
/// memory, and its effect is reported beside it.
#pragma once

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se {

/// Number of points above which fixes are tried only at the user's request.
inline constexpr std::size_t kManyForFixes = 20'000;

/// Tries the commands of all findings, each command once, and sets Finding::tried. Points that are
/// repaired or dropped are a new file, as the command writes it; so is each side judged by its own
/// points. The runs are by `paper`, as run makes them, and by `robust`; the command with --best is
/// tryChanges(). A fix helps if by one of them the mesh has fewer faults, and by none more. Fails
/// if cancelled. Deterministic.
Status tryFixes(const PointFile& file, Diagnosis& diagnosis, const Progress& progress = {});

}  // namespace se
