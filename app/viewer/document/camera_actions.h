/// Commands that move the camera by its rule (scene/framing.h).
#pragma once

#include <cstdint>
#include <optional>

#include "context.h"
#include "scene/camera_move.h"

namespace se::view {

enum class FrameRequest : std::uint8_t;

namespace actions {

/// All of the input, broadside.
void home(CommandContext& c);
/// All of the input; the direction stays.
void frameAll(CommandContext& c);
/// A smooth move to the selection, or to the view of the decision; everything if there is neither.
void frameSmoothly(CommandContext& c);
/// While it is on, the camera goes to the view of each decision.
void toggleFollow(CommandContext& c);
/// Shows depth by a swing of the view; again: stops it.
void swing(CommandContext& c);

}  // namespace actions

/// Frames the decision at the cursor: from that direction, a figure as the paper shows it, others
/// from the side that shows them best. No effect where there is none.
void frameDecision(CommandContext& context, std::optional<glm::vec3> from = {});
/// Frames the selection, else the decision at the cursor, else everything.
void frameFocus(CommandContext& context);
/// Frames a step of a lesson: everything, or the decision at the cursor where there is one; from
/// that direction, if it has one.
void frameStep(CommandContext& context, bool all, const std::optional<Vec3>& direction);
/// Frames what a command, a panel or an opening has requested.
void frameRequested(CommandContext& context, FrameRequest request);
/// A smooth move to the view of the decision at the cursor. No effect without a pivot.
void moveToDecision(CommandContext& context, CameraMove::Kind kind);
/// A smooth move to all of the mesh; the direction stays. No effect before an input is open.
void moveToAll(CommandContext& context, CameraMove::Kind kind);
/// A smooth move that brings the pivot back into the view, as close as before. Requires a pivot.
void followPivot(CommandContext& context);

}  // namespace se::view
