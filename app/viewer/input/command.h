/// A row of the table of actions, and finding one: for whatever runs an action by a key or by its
/// name. The table itself stands in commands/.
#pragma once

#include <span>
#include <string_view>

#include "keys.h"

namespace se::view {

struct CommandContext;

struct Command {
    std::string_view id;     ///< "step.pivot.next": menu path and stable name.
    std::string_view group;  ///< Menu and section of the cheat sheet.
    std::string_view title;
    std::string_view keys;  ///< "F10 .": one or more, separated by spaces; may be empty.
    std::string_view help;  ///< One sentence.
    void (*run)(CommandContext& context);
    /// Synonyms for the search of the palette, separated by spaces.
    std::string_view synonyms = {};
    bool repeats = false;  ///< Also while the key is held down.
};

std::span<const Command> commands();
const Command* findCommand(std::string_view id);

}  // namespace se::view
