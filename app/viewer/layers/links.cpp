#include "layer.h"

namespace se::view {

namespace {

void addList(const LayerInput& in, Index point, const Color& color, DrawList& out) {
    if (point == kNone) return;
    for (const Index q : in.model.points.neighbors[point]) {
        Line line;
        line.from = in.at(point);
        line.to = in.at(q);
        line.color = color;
        line.width = 0.06F;
        line.dash = 0.2F;
        line.depth = Depth::OnTop;
        out.lines.push_back(line);
    }
}

}  // namespace

void addLinks(const LayerInput& in, DrawList& out) {
    addList(in, in.picture.pivot, in.palette.unused, out);
    if (in.selected != in.picture.pivot) addList(in, in.selected, in.palette.accent, out);
}

}  // namespace se::view
