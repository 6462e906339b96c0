#include "layer_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "spiraling_edge/base/word_list.h"

namespace se::view {

namespace {

using nlohmann::json;

const Layer* findLayer(const std::string& name) {
    const auto all = layers();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Layer& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
}

std::optional<LayerMode> modeFrom(const json& value, const Layer& layer) {
    if (value.is_string()) return layerModeFromName(value.get<std::string>());
    if (!value.is_boolean()) return std::nullopt;
    // Earlier versions had no automatic layers: the default of that time is automatic now.
    const bool shown = layer.stages != kNoStage;
    if (value.get<bool>() == shown) return LayerMode::Automatic;
    return shown ? LayerMode::PinnedOff : LayerMode::PinnedOn;
}

}  // namespace

std::string ReadLayers::complaint() const {
    if (unknown.empty()) return {};
    return "Ignored, since unknown in this version: " + wordList(unknown, "") + ".";
}

ReadLayers layersFromJson(const json& object) {
    ReadLayers read;
    if (!object.is_object()) {
        read.unknown.push_back("\"layers\": " + object.dump());
        return read;
    }
    for (const auto& [name, value] : object.items()) {
        const Layer* layer = findLayer(name);
        if (layer == nullptr) {
            read.unknown.push_back("layer \"" + name + "\"");
        } else if (const auto mode = modeFrom(value, *layer)) {
            modeOf(read.modes, layer->id) = *mode;
        } else {
            read.unknown.push_back("mode " + value.dump() + " of layer \"" + name + "\"");
        }
    }
    return read;
}

json layersToJson(const LayerModes& modes) {
    json object = json::object();
    for (const Layer& layer : layers()) {
        object[std::string(layer.name)] = layerModeName(modes[static_cast<std::size_t>(layer.id)]);
    }
    return object;
}

}  // namespace se::view
