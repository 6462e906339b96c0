/// The user's choices that are kept in the settings. Plain values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/key_map.h"
#include "layers/layer.h"
#include "scene/mesh_style.h"
#include "scene/palette.h"
#include "scene/point_tint.h"
#include "scene/up_axis.h"

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

}  // namespace se::view
