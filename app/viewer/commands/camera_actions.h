/// Commands that move the camera to a decision.
#pragma once

#include "commands.h"
#include "scene/camera_move.h"

namespace se::view {

namespace actions {

/// A smooth move to the selection, or to the view of the decision; everything if there is neither.
void frameSmoothly(CommandContext& c);
/// While it is on, the camera goes to the view of each decision.
void toggleFollow(CommandContext& c);
/// Shows depth by a swing of the view; again: stops it.
void swing(CommandContext& c);

}  // namespace actions

/// Frames the decision at the cursor as one whose address is opened: a figure of the paper as the
/// paper shows it, others from the side that shows them best. No effect where there is none.
void frameDecision(CommandContext& context);
/// A smooth move to the view of the decision at the cursor. No effect without a pivot.
void moveToDecision(CommandContext& context, CameraMove::Kind kind);

}  // namespace se::view
