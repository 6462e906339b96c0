#include "layer.h"

namespace se::view {

void addTriangles(const LayerInput& in, DrawList& out) {
    out.meshVisible = true;
    out.finishedTriangles = in.picture.finishedTriangles;
    out.meshColor = in.palette.mesh;
    out.meshEdgeColor = in.mesh.style == MeshStyle::Wire ? in.palette.done : in.palette.meshEdge;
    // The mended mesh is in no order.
    const bool ordered = in.picture.mended == nullptr;
    out.meshStyle =
        ordered || in.mesh.style < MeshStyle::BirthOrder ? in.mesh.style : MeshStyle::Flat;
    out.birthEnd = in.mesh.birthEnd;
    for (std::size_t i = 0; ordered && i < in.mesh.starts.size(); ++i) {
        out.meshStretches.push_back({in.mesh.starts[i], componentColor(i)});
    }
    // New ones are among them, too; those below cover them.
    out.mended = in.picture.mended;
    for (const Triangle& t : in.picture.newTriangles) {
        out.faces.push_back({{in.at(t.a), in.at(t.b), in.at(t.c)}, in.palette.test, true});
    }
}

void addMeshEdges(const LayerInput&, DrawList& out) { out.meshEdges = true; }

}  // namespace se::view
