#include "layer.h"

namespace se::view {

void addTriangles(const LayerInput& in, DrawList& out) {
    out.meshVisible = true;
    out.finishedTriangles = in.picture.finishedTriangles;
    out.meshColor = in.palette.mesh;
    out.meshEdgeColor = in.palette.meshEdge;
    // New ones are among them, too; those below cover them.
    out.mended = in.picture.mended;
    for (const Triangle& t : in.picture.newTriangles) {
        out.faces.push_back({{in.at(t.a), in.at(t.b), in.at(t.c)}, in.palette.test, true});
    }
}

void addMeshEdges(const LayerInput&, DrawList& out) { out.meshEdges = true; }

}  // namespace se::view
