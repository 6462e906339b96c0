/// A window on a run of one's own program: the viewer at the place that a Stepper has come to.
#pragma once

#include <string>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {

/// Opens the viewer on the points, params and last pivot of `stepper`, and returns when its window
/// is closed. `viewer` is the program, by its name on PATH or its path. What the user does there
/// has no effect on the stepper. A session and its points lie in a folder for temporary files
/// meanwhile. Fails, with a sentence, if they cannot be written or the viewer ends with an error.
///
/// Example: `stepper.runUntil(condition); se::look(stepper);`
Status look(const Stepper& stepper, const std::string& viewer = "spiraling-edge-viewer");

/// The session that look() opens, on points in the file `points` beside it (docs/file-formats.md).
std::string sessionText(const Params& params, const std::string& points, std::uint32_t pivots);

}  // namespace se
