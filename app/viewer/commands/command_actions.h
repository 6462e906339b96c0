/// What the rows of the table of commands do.
#pragma once

#include <cstddef>

#include "commands.h"
#include "session/session.h"

namespace se::view::actions {

void pause(CommandContext& c);
/// Closes what lies over the panels and clears the selection.
void escape(CommandContext& c);
void nextMeshStyle(CommandContext& c);
void toggleTheme(CommandContext& c);
void home(CommandContext& c);
void restart(CommandContext& c);
/// Turns to look from the other side.
void oppositeView(CommandContext& c);
/// The axis that points up in what is open when it is opened: z for scenes and for points made
/// here; of files the one that was chosen, else that of a guess.
UpAxis usualUp(const CommandContext& c);
/// Lets an axis point up, in what is open and in the files opened from now on.
void chooseUp(CommandContext& c, UpAxis axis);
/// Forgets what was chosen: files have the axis of a guess.
void followUpAxis(CommandContext& c);
/// The next size of text and panels on the scale, up (+1) or down (-1).
void scaleBy(CommandContext& c, int direction);
void toggleBookmarkHere(CommandContext& c);
/// To the bookmark at a place of their list, from 0.
void toBookmark(CommandContext& c, std::size_t place);
void openBrowser(CommandContext& c);
void saveAs(CommandContext& c);
/// Asks where to save the mesh that the run ends with.
void saveMesh(CommandContext& c);
/// Puts the command line that makes that mesh on the clipboard.
void copyCommand(CommandContext& c);
/// Asks where to save points that were made here.
void savePoints(CommandContext& c);
/// Asks what is to be derived from the points of the input.
void openPrepare(CommandContext& c);
/// All rules as their set has them; what-ifs stay.
void resetRules(CommandContext& c);
/// All what-ifs away; rules stay.
void clearWhatIfs(CommandContext& c);
void toEnd(CommandContext& c);
void toStart(CommandContext& c);
/// To the next (+1) or previous (-1) mark of the run or bookmark.
void toMark(CommandContext& c, int direction);
void toggleUnit(CommandContext& c);
void playOrPause(CommandContext& c);
void stepByUnit(CommandContext& c, int direction);
void setLoopStart(CommandContext& c);
void setLoopEnd(CommandContext& c);
void arrange(CommandContext& c, Arrangement arrangement);
/// Opens a panel; where no panels are in sight, in the layout that has all of them.
void openTab(CommandContext& c, std::string_view tab);
/// To the decision that made the selected edge or triangle.
void goToBirth(CommandContext& c);

// Rows of the table take functions without arguments of their own.

template <LayerId layer>
void toggle(CommandContext& c) {
    toggleLayer(c.ui.settings.layers, layer, c.session.stage());
}

template <ViewPreset preset>
void setView(CommandContext& c) {
    c.camera.set(preset);
}

template <UpAxis axis>
void setUp(CommandContext& c) {
    chooseUp(c, axis);
}

template <MeshStyle style>
void setMeshStyle(CommandContext& c) {
    c.ui.settings.meshStyle = style;
}

template <PointTint tint>
void setPointTint(CommandContext& c) {
    c.ui.settings.pointTint = tint;
}

template <int direction>
void changeScale(CommandContext& c) {
    scaleBy(c, direction);
}

template <std::size_t place>
void goToBookmark(CommandContext& c) {
    toBookmark(c, place);
}

template <Arrangement arrangement>
void setArrangement(CommandContext& c) {
    arrange(c, arrangement);
}

}  // namespace se::view::actions
