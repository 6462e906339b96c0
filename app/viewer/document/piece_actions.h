/// Actions of the tool for a piece of a scan, and of points that take no part in the run.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>

#include "context.h"
#include "input/key_map.h"
#include "run/aside.h"

namespace se::view {

/// "1 204 points inside".
std::string insideText(std::size_t count);
/// Marks the points inside the closed line through `path`, at all depths, and counts them. In
/// pixels of the view, which is `size` large.
void enclosePoints(CommandContext& context, glm::vec2 size, std::span<const glm::vec2> path);
/// Runs again with the enclosed points alone.
void keepEnclosed(CommandContext& context);
/// Runs again without the enclosed points.
void leaveOutEnclosed(CommandContext& context);
/// Ends the tool, and clears its marks.
void endPieceTool(CommandContext& context);
/// Clears the enclosed points if another run is open; to be called once per frame.
void followRun(CommandContext& context);
/// Enter keeps, Delete leaves out. False: the key has its usual meaning.
bool runOnPieceTool(const KeyChord& chord, CommandContext& context);

/// Shows the points in the view: frames them, and pins their layer on if it is off.
void showAside(CommandContext& context, const AsidePoints& group);
/// Runs again with points that took no part in the run. Requires a returnText().
void bringBack(CommandContext& context, const AsidePoints& group);

namespace actions {

/// Begins or ends the tool.
void togglePieceTool(CommandContext& c);

}  // namespace actions

}  // namespace se::view
