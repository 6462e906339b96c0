/// All actions, in one table that feeds keys, menus, the cheat sheet and --list-actions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/keys.h"
#include "panel_state/ui_state.h"

namespace se::view {

struct Command {
    std::string_view id;     ///< "step.pivot.next": menu path and stable name.
    std::string_view group;  ///< Menu and section of the cheat sheet.
    std::string_view title;
    std::string_view keys;  ///< "F10 .": one or more, separated by spaces; may be empty.
    std::string_view help;  ///< One sentence.
    bool repeats;           ///< Also while the key is held down.
    void (*run)(CommandContext& context);
    /// Synonyms for the search of the palette, separated by spaces.
    std::string_view synonyms = {};
};

std::span<const Command> commands();
const Command* findCommand(std::string_view id);
/// The command of a key, null if it has none.
const Command* commandForKey(const KeyChord& chord);
/// First key of a command, for menus; empty if it has none.
std::string firstKey(const Command& command);
/// All keys, joined by ", ".
std::string allKeys(const Command& command);
/// One line per action: id, keys, help.
std::string listActions();

/// Moves by `count` playback units, at most to the end of the loop; back if it is
/// negative.
void playSteps(CommandContext& context, int count);
/// Centers the pivot and its neighbors, or the selection, in the view.
void frameFocus(CommandContext& context);
/// Centers the pivot regardless of the selection; no effect without a pivot.
void framePivot(CommandContext& context);

}  // namespace se::view
