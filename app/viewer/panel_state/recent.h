/// State that the program keeps by itself from one run to the next: the layout of the window and
/// the recent files. Not settings, which the user writes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "session/layout_preset.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

inline constexpr std::size_t kMaxRecent = 10;

struct KeptState {
    LayoutPreset layout = LayoutPreset::Debug;
    std::vector<std::string> recent;  ///< Absolute paths, the latest first.
    friend bool operator==(const KeptState&, const KeptState&) = default;
};

/// Puts a file, or sampled points (sample:...), at the front, once, and drops the oldest
/// ones. Scenes are not recorded.
void remember(KeptState& state, const std::string& path);
/// Label in a list of recent files: the name of a file without its folder, "torus, 4 000 points".
std::string recentName(const std::string& path);

/// $XDG_STATE_HOME/spiraling-edge/state.json, or below ~/.local/state. Empty if there is no home.
std::filesystem::path statePath();

/// Anything that cannot be read is skipped silently: recent files are not worth a message.
KeptState keptStateFromJson(std::string_view text);
std::string keptStateToJson(const KeptState& state);

/// The defaults if there is no such file.
KeptState readKeptState(const std::filesystem::path& path);
/// Makes the folder if necessary; an empty path has no effect.
Status writeKeptState(const std::filesystem::path& path, const KeptState& state);

}  // namespace se::view
