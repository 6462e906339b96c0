/// What the doctor advises, done to an input between reading and preparing it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::view {

/// Names of checks (doctor.h) whose advice is followed, one after the other.
using Cures = std::vector<std::string>;

/// The advice on a finding can be followed here.
bool canCure(const DoctorCheck& check);
/// What following it does, as a sentence for a person.
std::string_view cureText(Cure cure);
/// The cures of all findings that need no decision: what is mended without guessing, and normals
/// that are to be turned. Each kind once.
Cures plainCures(std::span<const Finding> findings);

/// Follows the advice: mends `file`, and sets in `options` what preparing is to do. Returns one
/// sentence for each thing that was done to the file. Fails if there is no such check, if it has no
/// cure, or if cancelled. Deterministic.
Result<std::vector<std::string>> cure(PointFile& file, const Cures& cures, PrepareOptions& options,
                                      const Progress& progress = {});
/// After preparing: what was made anew goes into the file, so that the doctor looks at what is run.
/// Returns sentences likewise.
std::vector<std::string> takeOverCured(const Prepared& prepared, const PrepareOptions& options,
                                       const Cures& cures, PointFile& file);

}  // namespace se::view
