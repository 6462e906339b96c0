#include "layer.h"

namespace se::view {

/// Highlighted points, such as those of a finding: a ring around each, over everything else.
void addMarked(const LayerInput& in, DrawList& out) {
    for (const Index p : in.marked) {
        if (!in.model.drawable[p]) continue;
        out.mark(in.at(p), Shape::OpenDiamond, in.palette.rejected, 0.95F);
    }
}

}  // namespace se::view
