// The table of layers: name, title, stages in which a layer is on by itself, and its function.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "layer.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/word_list.h"
#include "teach/lesson.h"

namespace se::view {

namespace {

constexpr std::array<Layer, kLayerCount> kLayers = {{
    {LayerId::Points, "points", "Points", kEveryStage, addPoints},
    {LayerId::Aside, "aside", "Points set aside", kEveryStage, addAside},
    {LayerId::Triangles, "triangles", "Triangles", kEveryStage, addTriangles},
    {LayerId::MeshEdges, "edges", "Mesh edges", kEveryStage, addMeshEdges},
    {LayerId::EdgeRing, "ring", "Edge ring", kEveryStage, addEdgeRing},
    {LayerId::StackedRings, "stack", "Stacked rings", kEveryStage, addStackedRings},
    {LayerId::Sector, "sector", "Tangent disc of the pivot", kEveryStage, addSector},
    {LayerId::NeighborRing, "neighbors", "Pivot and candidates", kEveryStage, addNeighborRing},
    {LayerId::Seed, "seed", "Seed of a ring", during(Stage::Seed, Stage::Strand), addSeed},
    {LayerId::Walls, "walls", "Walls of the box", during(Stage::Skip, Stage::Insert), addWalls},
    {LayerId::SortAngles, "angles", "Angle of a candidate", during(Stage::Sort), addSortAngles},
    {LayerId::Limits, "limits", "Corners at start and end", during(Stage::Limits), addLimits},
    {LayerId::Convexity, "convex", "Convexity test", during(Stage::Convex), addConvexity},
    {LayerId::Reciprocal, "reciprocal", "Reciprocal test", during(Stage::Reciprocal),
     addReciprocal},
    {LayerId::HolePlane, "hole", "Plane of a hole", during(Stage::Hole), addHolePlane},
    {LayerId::Spheres, "spheres", "Circumsphere of a test", during(Stage::Sphere), addCircumsphere},
    {LayerId::TwoPoint, "twopoint", "Triangle of two points", during(Stage::TwoPoint), addTwoPoint},
    {LayerId::Fan, "fan", "Numbers of new triangles", during(Stage::Emit), addFan},
    {LayerId::RingChange, "change", "Old and new path of the ring", during(Stage::Ring),
     addRingChange},
    {LayerId::Exchange, "exchange", "Split and join", during(Stage::Split, Stage::Join),
     addExchange},
    {LayerId::Advance, "advance", "Way to the next pivot", during(Stage::Advance), addAdvance},
    {LayerId::Component, "component", "Finished component", during(Stage::Done), addComponent},
    {LayerId::Guard, "guard", "Objection to a fan", during(Stage::Guard), addGuard},
    {LayerId::HoleFill, "fill", "Ear of a hole", during(Stage::Fill), addHoleFill},
    {LayerId::Repairs, "mending", "Flips, points put in or out",
     during(Stage::DropPatch, Stage::Reinsert, Stage::CloseHole, Stage::Flip, Stage::Remesh),
     addRepairs},
    {LayerId::Normals, "normals", "Normals near the pivot", kNoStage, addNormals},
    {LayerId::Links, "links", "Neighbor links", kNoStage, addLinks},
    {LayerId::Labels, "labels", "Labels", kEveryStage, addLabels},
    {LayerId::Selection, "selection", "Selected edge or triangle", kEveryStage, addSelection},
    {LayerId::Marked, "marked", "Marked points", kEveryStage, addMarked},
    {LayerId::Alerts, "alerts", "Alerts", kEveryStage, addAlerts},
}};

// By these a lesson is checked without a viewer.
static_assert(std::equal(kLayers.begin(), kLayers.end(), teach::kLayerNames.begin(),
                         teach::kLayerNames.end(), [](const Layer& layer, std::string_view name) {
                             return layer.name == name;
                         }));

constexpr std::array<std::string_view, 3> kModeNames = {"auto", "on", "off"};

bool shownByItself(const Layer& layer, std::optional<Stage> stage) {
    if (!stage) return layer.stages == kEveryStage;
    return (layer.stages & during(*stage)) != 0;
}

bool isShown(const Layer& layer, LayerMode mode, std::optional<Stage> stage) {
    return mode == LayerMode::Automatic ? shownByItself(layer, stage) : mode == LayerMode::PinnedOn;
}

}  // namespace

std::span<const Layer> layers() { return kLayers; }

const Layer& rowOf(LayerId id) {
    return *rowWhere(kLayers, [&](const Layer& layer) { return layer.id == id; });
}

std::string_view layerModeName(LayerMode mode) {
    return kModeNames[static_cast<std::size_t>(mode)];
}

std::optional<LayerMode> layerModeFromName(std::string_view name) {
    return idNamed<LayerMode>(kModeNames, name);
}

LayerMode& modeOf(LayerModes& modes, LayerId id) { return modes[static_cast<std::size_t>(id)]; }

LayerSwitches shownLayers(const LayerModes& modes, std::optional<Stage> stage) {
    LayerSwitches shown;
    for (const Layer& layer : kLayers) {
        const auto place = static_cast<std::size_t>(layer.id);
        shown.set(place, isShown(layer, modes[place], stage));
    }
    return shown;
}

void toggleLayer(LayerModes& modes, LayerId id, std::optional<Stage> stage) {
    const Layer& layer = rowOf(id);
    LayerMode& mode = modeOf(modes, id);
    const bool show = !isShown(layer, mode, stage);
    mode = shownByItself(layer, stage) == show ? LayerMode::Automatic
           : show                              ? LayerMode::PinnedOn
                                               : LayerMode::PinnedOff;
}

void fillDrawList(const LayerInput& in, const LayerSwitches& on, DrawList& out) {
    out.clear();
    out.cloudVisible = out.meshVisible = out.meshEdges = false;
    for (const Layer& layer : kLayers) {
        if (!on.test(static_cast<std::size_t>(layer.id))) continue;
        out.layers.push_back({layer.title, out.lines.size(), out.sheets.size(), out.spheres.size(),
                              out.sprites.size()});
        layer.add(in, out);
    }
}

namespace {

using nlohmann::json;

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
        read.unknown.push_back("\"layers\": " + excerpt(object.dump()));
        return read;
    }
    for (const auto& [name, value] : object.items()) {
        const Layer* layer = findNamed(layers(), name);
        if (layer == nullptr) {
            read.unknown.push_back("layer " + inQuotes(name));
        } else if (const auto mode = modeFrom(value, *layer)) {
            modeOf(read.modes, layer->id) = *mode;
        } else {
            read.unknown.push_back("mode " + excerpt(value.dump()) + " of layer " + inQuotes(name));
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
