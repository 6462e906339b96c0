/// Modes of layers as settings and session files have them, read by one rule: what is not known is
/// left out and named, the rest holds.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "layer.h"

namespace se::view {

struct ReadLayers {
    LayerModes modes{};
    std::vector<std::string>
        unknown;  ///< "layer \"hologram\"", "mode \"maybe\" of layer \"points\"".

    /// A sentence about them; empty if there are none.
    std::string complaint() const;
};

/// `object`: {"normals": "on"}. Earlier versions wrote true and false.
ReadLayers layersFromJson(const nlohmann::json& object);
/// All layers, whatever their mode.
nlohmann::json layersToJson(const LayerModes& modes);

}  // namespace se::view
