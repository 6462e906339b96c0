/// The user's choices that survive a restart: a small JSON file in the configuration folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/key_map.h"
#include "layers/layer.h"
#include "scene/mesh_style.h"
#include "scene/palette.h"
#include "scene/point_tint.h"
#include "scene/up_axis.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

/// Kept in the settings.
struct ViewSettings {
    Theme theme = Theme::Dark;
    double uiScale = 0.0;  ///< 0: that of the monitor.
    LayerModes layers{};
    int width = 1280;
    int height = 800;
    double playRate = 4.0;
    bool legend = true;
    KeyMap keys;
    std::vector<std::string> complaints;  ///< Errors in the settings, one sentence each.
    MeshStyle meshStyle = MeshStyle::Flat;
    PointTint pointTint = PointTint::Status;
    std::optional<UpAxis> up;  ///< For files; empty: guessed for each.
};

/// The folder named by the variable, or `below` the home folder. Empty if there is no home.
std::filesystem::path xdgFolder(const char* variable, const char* below);
/// $XDG_CONFIG_HOME/spiraling-edge/settings.json, or below ~/.config. Empty if there is no home.
std::filesystem::path settingsPath();

/// Unknown fields are ignored, values out of range replaced by the default.
Result<ViewSettings> settingsFromJson(std::string_view text);
std::string settingsToJson(const ViewSettings& settings);

/// The settings of a file; the defaults if there is none.
Result<ViewSettings> readSettings(const std::filesystem::path& path);
/// Writes a file of the user's folders, which is made if necessary; an empty path has no effect.
Status writeKept(const std::filesystem::path& path, const std::string& text);
Status writeSettings(const std::filesystem::path& path, const ViewSettings& settings);

}  // namespace se::view
