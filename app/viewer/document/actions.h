/// Actions on the open run and the window, called by commands, panels and lessons.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "context.h"
#include "scene/camera.h"
#include "scene/motion.h"
#include "session/playback.h"
#include "session/session.h"
#include "ui_state.h"

namespace se::view {

/// Moves by `count` playback units, at most to the end of the loop; back if it is
/// negative.
void playSteps(CommandContext& context, int count);

inline constexpr const char* kNoChangedRules = "All rules have the values of their set.";
inline constexpr const char* kNoWhatIfs = "No what-ifs are active.";

namespace actions {

void pause(CommandContext& c);
/// Closes the overlays above the panels and clears the selection.
void escape(CommandContext& c);
void nextMeshStyle(CommandContext& c);
void toggleTheme(CommandContext& c);
/// Turns to look from the opposite side.
void oppositeView(CommandContext& c);
/// The up axis of an input when it is opened: z for scenes and sampled points; for files the
/// chosen axis, otherwise a guess.
UpAxis usualUp(const CommandContext& c);
/// Sets the up axis of the open input and of files opened from now on.
void chooseUp(CommandContext& c, UpAxis axis);
/// Resets the choice: files use the guessed axis.
void followUpAxis(CommandContext& c);
/// The next size of text and panels on the scale, larger (+1) or smaller (-1).
void scaleBy(CommandContext& c, int direction);
void toggleBookmarkHere(CommandContext& c);
/// Opens what was chosen in the dialog for a task: an input, a mesh to compare with, or a volume.
void openFor(CommandContext& c, BrowserTask task, const std::string& source);
/// Opens the dialog for saving the mesh at the end of the run.
void saveMesh(CommandContext& c);
/// Copies the command line that makes that mesh to the clipboard.
void copyCommand(CommandContext& c);
/// Opens the dialog for saving sampled points.
void savePoints(CommandContext& c);
/// Opens the dialog for what is derived from the points of the input.
void openPrepare(CommandContext& c);
/// Resets all rules to the values of their set; what-ifs stay.
void resetRules(CommandContext& c);
/// To the next (+1) or previous (-1) mark of the run or bookmark.
void toMark(CommandContext& c, int direction);
/// Pauses, and shows the decision unless the user has picked another task.
void step(CommandContext& c);
void playOrPause(CommandContext& c);
void stepByUnit(CommandContext& c, int direction);
void applyLayoutPreset(CommandContext& c, LayoutPreset layoutPreset);
/// Covers the window, in the layout Present.
void blankScreen(CommandContext& c, BlankScreen with);
/// Opens the part of the column with the result of an action, in Present in the layout that has a
/// column: the next step shows the decision again. Requires a title of partRows().
void showPart(CommandContext& c, std::string_view title);
/// The user opens a part: it stays.
void openPart(CommandContext& c, std::string_view title);
/// The user picks a task of the rail; the open one folds the column.
void pickTask(CommandContext& c, Task task);
/// Turns the plane of the section by 15 degrees, counterclockwise (+1) or clockwise (-1), and opens
/// its panel.
void turnSection(CommandContext& c, int direction);
/// Folds the column to its rail, or unfolds it.
void foldColumn(CommandContext& c);
/// To the decision that made the selected edge or triangle.
void goToCreation(CommandContext& c);

/// Pins a layer on or off.
void toggle(CommandContext& c, LayerId layer);
/// Sets an end of the playback loop to the cursor; `end` is its name.
void setLoop(CommandContext& c, const char* end, void (PlayLoop::*set)(const Address& address));
/// Opens the file dialog.
void openBrowser(CommandContext& c, BrowserTask task);
void openPalette(CommandContext& c);
/// Opens the box with the address.
void openGoTo(CommandContext& c);

/// Pauses, in the layout Compare.
void enterCompare(CommandContext& c);

/// Gives the keyboard focus to the next (+1) or previous (-1) panel.
void walkPanels(CommandContext& c, int direction);

}  // namespace actions

// Commands that move the camera by its rule (scene/framing.h).

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

}  // namespace actions

/// Frames the decision at the cursor: from that direction, a figure as the paper shows it, others
/// from the side that shows them best. No effect where there is none.
void frameDecision(CommandContext& context, std::optional<glm::vec3> from = {});
/// Frames a step of a lesson: everything, or the decision at the cursor where there is one; from
/// that direction, if it has one.
void frameStep(CommandContext& context, bool all, const std::optional<Vec3>& direction);
/// Moves of a jump, which ends a play: the decision is framed where they end, if its pivot is
/// outside of the view there.
Moves& jumpingMoves(CommandContext& context);
/// The request for what is framed: none instead of `Unseen` where the pivot is in the view.
FrameRequest resolved(const CommandContext& context, FrameRequest request);
/// Frames what a command, a panel or an opening has requested, as resolved().
void frameRequested(CommandContext& context, FrameRequest request);
/// A smooth move to the view of the decision at the cursor. No effect without a pivot.
void moveToDecision(CommandContext& context, CameraMove::Kind kind);
/// A smooth move to all of the mesh; the direction stays. No effect before an input is open.
void moveToAll(CommandContext& context, CameraMove::Kind kind);
/// A smooth move that brings the pivot back into the view, as close as before. Requires a pivot.
void followPivot(CommandContext& context);

}  // namespace se::view
