#include "layer.h"

namespace se::view {

namespace {

/// Number of points up to which all their normals are drawn.
constexpr std::size_t kAllUpTo = 3000;

void addNormal(const LayerInput& in, Index point, DrawList& out) {
    const glm::vec3& from = in.at(point);
    out.line(from, from + in.model.normal[point] * (0.8F * in.model.spacing),
             in.palette.unused.withAlpha(0.8F), 0.05F);
}

}  // namespace

void addNormals(const LayerInput& in, DrawList& out) {
    const std::size_t count = in.model.points.size();
    if (count <= kAllUpTo) {
        for (Index p = 0; p < count; ++p) {
            if (in.model.drawable[p]) addNormal(in, p, out);
        }
        return;
    }
    if (in.picture.pivot == kNone) return;
    addNormal(in, in.picture.pivot, out);
    for (const Index q : in.model.points.neighbors[in.picture.pivot]) addNormal(in, q, out);
}

}  // namespace se::view
