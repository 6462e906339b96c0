/// Settings that survive a restart: a small JSON file in the user's configuration folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "spiraling_edge/base/result.h"
#include "view_settings.h"

namespace se::view {

/// The folder named by the variable, or `below` the home folder. Empty if there is no home.
std::filesystem::path xdgFolder(const char* variable, const char* below);
/// $XDG_CONFIG_HOME/spiraling-edge/settings.json, or below ~/.config. Empty if there is no home.
std::filesystem::path settingsPath();

/// Unknown fields are ignored, values out of range replaced by the default.
Result<ViewSettings> settingsFromJson(std::string_view text);
std::string settingsToJson(const ViewSettings& settings);

/// The settings of a file; the defaults if there is none.
Result<ViewSettings> readSettings(const std::filesystem::path& path);
/// Makes the folder if necessary.
Status writeSettings(const std::filesystem::path& path, const ViewSettings& settings);

}  // namespace se::view
