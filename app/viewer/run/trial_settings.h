/// The options of an input as core's settings of a run (run_settings.h), and back.
#pragma once

#include <string>

#include "model.h"
#include "spiraling_edge/explain/run_settings.h"
#include "spiraling_edge/explain/trial.h"

namespace se::view {

/// The settings of the run of an input; `given` is the file that is prepared, with its fixes.
RunSettings settingsOf(const InputSpec& spec, const PointFile& given);
/// The input after a change of its settings; points that the change drops become a fix.
InputSpec withChange(InputSpec spec, const SettingsChange& change);

/// "No better settings among 5 changes tried." Requires a trial.
std::string noneBetterText(const Trials& trials);

}  // namespace se::view
