/// The search for the settings that suit an input best: `run --best`.
#pragma once

#include <string>

#include "progress.h"
#include "spiraling_edge/explain/trial.h"

namespace se::cli {

/// Tries changes of `settings` with the line of progress. Throws Failure as runWithProgress() does.
Trials tryOthers(const PointFile& file, const RunSettings& settings, const std::string& input,
                 ProgressLine& line);
/// The settings of the best trial; the points that it leaves out are in their PrepareOptions.
RunSettings bestOf(const Trials& trials, const RunSettings& settings);

}  // namespace se::cli
