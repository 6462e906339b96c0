#include <array>

#include "layer.h"

namespace se::view {

namespace {

constexpr std::array<Layer, kLayerCount> kLayers = {{
    {LayerId::Points, "points", "Points", true, addPoints},
    {LayerId::Triangles, "triangles", "Triangles", true, addTriangles},
    {LayerId::MeshEdges, "edges", "Mesh edges", true, addMeshEdges},
    {LayerId::EdgeRing, "ring", "Active edge ring", true, addEdgeRing},
    {LayerId::StackedRings, "stack", "Stacked rings", true, addStackedRings},
    {LayerId::Sector, "sector", "Free sector of the pivot", true, addSector},
    {LayerId::NeighborRing, "neighbors", "Pivot and candidates", true, addNeighborRing},
    {LayerId::Spheres, "spheres", "Circumsphere of a test", true, addCircumsphere},
    {LayerId::Normals, "normals", "Normals near the pivot", false, addNormals},
    {LayerId::Links, "links", "Neighbor links", false, addLinks},
    {LayerId::Labels, "labels", "Labels", true, addLabels},
}};

}  // namespace

std::span<const Layer> layers() { return kLayers; }

LayerSwitches defaultLayers() {
    LayerSwitches on;
    for (const Layer& layer : kLayers) on.set(static_cast<std::size_t>(layer.id), layer.onAtFirst);
    return on;
}

void fillDrawList(const LayerInput& in, const LayerSwitches& on, DrawList& out) {
    out.clear();
    out.cloudVisible = out.meshVisible = out.meshEdges = false;
    for (const Layer& layer : kLayers) {
        if (on.test(static_cast<std::size_t>(layer.id))) layer.add(in, out);
    }
}

}  // namespace se::view
