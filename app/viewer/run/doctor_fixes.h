/// The doctor's advice, applied to an input between reading and preparing it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "aside.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::view {

/// True if the viewer can apply the fix of a finding.
bool canFix(const DoctorCheck& check);
/// Effect of a fix, as a sentence for the user.
std::string_view fixText(Fix fix);
/// The fixes of all findings that need no decision: repairs without guessing, and normals to be
/// flipped. Each kind once.
std::vector<std::string> safeFixes(std::span<const Finding> findings);

/// The effects of the fixes of a file.
struct FixesDone {
    std::vector<std::string> texts;    ///< One sentence for each change of the file.
    std::vector<AsidePoints> dropped;  ///< The points that each fix dropped.
    std::vector<Index> kept;           ///< Index before, of each point that is left.
};

/// Applies the fixes that change the file; withFixesAsOptions() has the others. Fails if there is
/// no such check, if it has no fix, if together they leave fewer than half of the places
/// (requireMostLeft()), or if cancelled. A fix that drops most points by itself is applied, unless
/// none is left: the panel has asked the user. Deterministic.
Result<FixesDone> fixInput(PointFile& file, const std::vector<std::string>& fixes,
                           const Progress& progress = {});
/// Copies derived data back into the file after preparing, so that the doctor examines the input
/// of the run. Returns one sentence for each change.
std::vector<std::string> storeFixed(const Prepared& prepared, const PrepareOptions& options,
                                    const std::vector<std::string>& fixes, PointFile& file);

}  // namespace se::view
