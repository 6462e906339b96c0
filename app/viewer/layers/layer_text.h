/// Modes of layers in settings and session files, read by one rule: unknown names are skipped and
/// reported, the rest is used.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "layer.h"

namespace se::view {

struct ReadLayers {
    LayerModes modes{};
    /// "layer \"hologram\"", "mode \"maybe\" of layer \"points\"".
    std::vector<std::string> unknown;

    /// A sentence about the skipped names; empty if there are none.
    std::string complaint() const;
};

/// `object`: {"normals": "on"}. Earlier versions wrote true and false.
ReadLayers layersFromJson(const nlohmann::json& object);
/// All layers, whatever their mode.
nlohmann::json layersToJson(const LayerModes& modes);

}  // namespace se::view
