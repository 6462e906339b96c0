/// What the program remembers by itself from one time to the next: the layout of the window and the
/// files that were open. Not settings, which a person writes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "session/layout_preset.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

inline constexpr std::size_t kMostRecent = 10;

struct KeptState {
    Arrangement layout = Arrangement::Debug;
    std::vector<std::string> recent;  ///< Absolute paths, the latest first.
    friend bool operator==(const KeptState&, const KeptState&) = default;
};

/// Puts a file, or points that were made (sample:...), at the front, once, and forgets the oldest
/// ones. Scenes are not remembered.
void remember(KeptState& state, const std::string& path);
/// What a list of them shows: the name of a file without its folder, "torus, 4 000 points".
std::string recentName(const std::string& path);

/// $XDG_STATE_HOME/spiraling-edge/state.json, or below ~/.local/state. Empty if there is no home.
std::filesystem::path statePath();

/// Whatever cannot be read is left out: nobody is told of a list of recent files.
KeptState keptStateFromJson(std::string_view text);
std::string keptStateToJson(const KeptState& state);

/// The defaults if there is no such file.
KeptState readKeptState(const std::filesystem::path& path);
/// Makes the folder if need be; an empty path is nothing to do.
Status writeKeptState(const std::filesystem::path& path, const KeptState& state);

}  // namespace se::view
