/// State that survives a restart, in two small JSON files: the settings, which the user may write,
/// in the configuration folder; and the layout of the window and the recent files, which the
/// program keeps by itself, in the state folder.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "column.h"
#include "input/key_map.h"
#include "layers/layer.h"
#include "layout/panel_rects.h"
#include "scene/camera.h"
#include "scene/mesh_style.h"
#include "scene/palette.h"
#include "session/layout_preset.h"
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
    bool names = true;  ///< Points of figures have the paper's letters.
    PanelSizes panels;
    FoldedParts parts;  ///< Of the column.
    KeyMap keys;
    std::vector<std::string> complaints;  ///< Errors in the settings, one sentence each.
    MeshStyle meshStyle = MeshStyle::Faults;
    PointTint pointTint = PointTint::Status;
    std::optional<UpAxis> up;  ///< For files; empty: guessed for each.
};

/// $XDG_CONFIG_HOME/spiraling-edge/settings.json, or below ~/.config. Empty if there is no home.
std::filesystem::path settingsPath();

/// Unknown fields are ignored, values out of range replaced by the default.
Result<ViewSettings> settingsFromJson(std::string_view text);
std::string settingsToJson(const ViewSettings& settings);

/// The settings of a file; the defaults, with the usual theme, if there is none, or with a
/// complaint if it cannot be read.
ViewSettings readSettings(const std::filesystem::path& path, Theme usual = Theme::Dark);
/// Writes what differs from `before`, the settings as they were read (writeKept()).
Status writeSettings(const std::filesystem::path& path, const ViewSettings& before,
                     const ViewSettings& settings);

inline constexpr std::size_t kMaxRecent = 10;

struct KeptState {
    LayoutPreset layout = LayoutPreset::Debug;
    std::vector<std::string> recent;                  ///< Absolute paths, the latest first.
    std::map<std::string, std::size_t> lessons = {};  ///< The last step, from 0, by source.
    friend bool operator==(const KeptState&, const KeptState&) = default;
};

/// Puts a file, or sampled points (sample:...), at the front, once, and drops the oldest
/// ones. Scenes are not recorded.
void remember(KeptState& state, const std::string& path);
/// Label in a list of recent files: the name of a file without its folder, "torus, 4 000 points".
std::string recentName(const std::string& path);

/// $XDG_STATE_HOME/spiraling-edge/state.json, or below ~/.local/state. Empty if there is no home.
std::filesystem::path statePath();

/// A value that cannot be read is skipped silently: recent files are not worth a message.
KeptState keptStateFromJson(std::string_view text);
std::string keptStateToJson(const KeptState& state);

/// The defaults if there is no such file.
KeptState readKeptState(const std::filesystem::path& path);

/// The state as a file; without a path nothing is kept.
class KeptFile {
  public:
    void open(const std::filesystem::path& path) { path_ = path; }
    bool isOpen() const { return !path_.empty(); }
    KeptState read() const { return isOpen() ? readKeptState(path_) : KeptState{}; }
    /// keptComplaint() of the file.
    std::string complaint() const;
    /// Changes the state as it is on disk, where another window may have stored something since
    /// (writeKept()).
    Status change(const std::function<void(KeptState&)>& change) const;

  private:
    std::filesystem::path path_;
};

}  // namespace se::view
