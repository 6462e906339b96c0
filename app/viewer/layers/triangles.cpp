#include <algorithm>

#include "layer.h"

namespace se::view {

void addTriangles(const LayerInput& in, DrawList& out) {
    out.meshVisible = true;
    out.finishedTriangles = in.picture.finishedTriangles;
    out.meshColor = in.palette.mesh;
    out.meshEdgeColor = in.palette.meshEdge;
    if (in.picture.mended) {
        const std::vector<Triangle>& fresh = in.picture.newTriangles;
        for (const Triangle& t : *in.picture.mended) {
            if (std::find(fresh.begin(), fresh.end(), t) != fresh.end()) continue;
            for (const Index p : {t.a, t.b, t.c}) out.meshCorners.push_back(in.at(p));
        }
    }
    for (const Triangle& t : in.picture.newTriangles) {
        out.faces.push_back({{in.at(t.a), in.at(t.b), in.at(t.c)}, in.palette.test, true});
    }
}

void addMeshEdges(const LayerInput&, DrawList& out) { out.meshEdges = true; }

}  // namespace se::view
