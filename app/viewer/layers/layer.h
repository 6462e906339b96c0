/// Layers turn (input, picture, selection) into plain things to draw. One file each; the table
/// names them for the panel, the keys and the settings.
#pragma once

#include <bitset>
#include <span>
#include <string_view>

#include "../draw_list.h"
#include "../model.h"
#include "../palette.h"
#include "../picture.h"

namespace se::view {

struct LayerInput {
    const Model& model;
    const Picture& picture;
    const Palette& palette;
    Index selected = kNone;
    Index highlightedRing = kNone;
    Index hovered = kNone;

    const glm::vec3& at(Index point) const { return model.place[point]; }
};

void addPoints(const LayerInput& in, DrawList& out);
void addTriangles(const LayerInput& in, DrawList& out);
void addMeshEdges(const LayerInput& in, DrawList& out);
void addEdgeRing(const LayerInput& in, DrawList& out);
void addStackedRings(const LayerInput& in, DrawList& out);
void addNeighborRing(const LayerInput& in, DrawList& out);
void addSector(const LayerInput& in, DrawList& out);
void addCircumsphere(const LayerInput& in, DrawList& out);
void addNormals(const LayerInput& in, DrawList& out);
void addLinks(const LayerInput& in, DrawList& out);
void addLabels(const LayerInput& in, DrawList& out);

enum class LayerId : std::uint8_t {
    Points,
    Triangles,
    MeshEdges,
    EdgeRing,
    StackedRings,
    Sector,
    NeighborRing,
    Spheres,
    Normals,
    Links,
    Labels,
};
inline constexpr std::size_t kLayerCount = 11;

struct Layer {
    LayerId id;
    std::string_view name;   ///< In settings and command names.
    std::string_view title;  ///< For people.
    bool onAtFirst;
    void (*add)(const LayerInput& in, DrawList& out);
};

/// In drawing order.
std::span<const Layer> layers();

using LayerSwitches = std::bitset<kLayerCount>;
LayerSwitches defaultLayers();

/// Fills `out` with all layers that are on. The result depends on nothing else.
void fillDrawList(const LayerInput& in, const LayerSwitches& on, DrawList& out);

}  // namespace se::view
