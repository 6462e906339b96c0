/// All actions, in one table that feeds keys, menus, the cheat sheet and --list-actions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document/context.h"
#include "input/key_map.h"

namespace se::view {

/// One line per action: id, keys, help.
std::string listActions();

/// Why a command cannot act now, for rows of menus that are gray: a sentence; empty if it can act,
/// or if only trying tells.
std::string_view whyUnavailable(const Command& command, const CommandContext& context);

/// Runs a command, from a key, a menu or the list of actions.
void runCommand(const Command& command, CommandContext& context);

// Entries of the command palette: actions, panels, lessons and scenes. No ImGui.

/// One line of the palette.
struct PaletteEntry {
    enum class Kind : std::uint8_t { Action, Panel, Scene, Lesson };
    Kind kind = Kind::Action;
    std::string_view title;
    std::string_view note;      ///< Group: the menu of an action, otherwise the kind.
    std::string_view synonyms;  ///< Synonyms, separated by spaces.
    std::string_view id;  ///< Of the action or scene; of a panel its title, of a lesson its source.
    std::string_view help;
};

/// All of them: actions as in their table, then the parts of the column, then lessons, then scenes,
/// those that fail last. A part with the title of an action is listed once, as the action.
std::vector<PaletteEntry> paletteEntries();

/// The entries in which every word of `filter` begins a word, in any case: of the title, of
/// its synonyms, or otherwise of group, id and help. The one with exactly that title comes first,
/// then those with the words in the title, in title and synonyms, elsewhere. All without a filter.
std::vector<PaletteEntry> matchingEntries(std::span<const PaletteEntry> entries,
                                          std::string_view filter);

/// Runs an action, shows a panel, opens a lesson or a scene.
void choose(const PaletteEntry& entry, CommandContext& context);

}  // namespace se::view
