// A linked list per point in two arrays: corner 3 t + k is corner k of triangle t, and points to
// the previous corner of the same point. Adding a triangle costs amortized constant time, since
// the run only ever appends them.
#include "mesh_index.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "run/selection.h"

namespace se::view {

void MeshIndex::append(const Model& model, std::span<const Triangle> all) {
    head_.resize(model.place.size(), kNone);
    reach_.resize(model.place.size(), 0.0F);
    const std::size_t known = triangleCount();
    if (all.size() <= known) return;
    next_.reserve(std::max(3 * all.size(), next_.capacity()));
    for (const Triangle& t : all.subspan(known)) {
        for (const Index p : {t.a, t.b, t.c}) {
            next_.push_back(head_[p]);
            head_[p] = static_cast<std::uint32_t>(next_.size() - 1);
        }
        const glm::vec3& a = model.place[t.a];
        reach_[t.a] = std::max(
            {reach_[t.a], glm::distance(a, model.place[t.b]), glm::distance(a, model.place[t.c])});
    }
}

std::vector<std::uint32_t> MeshIndex::atEdge(std::span<const Triangle> all, Index a,
                                             Index b) const {
    std::vector<std::uint32_t> found;
    forEachAt(a, [&](std::uint32_t t) {
        const Triangle& each = all[t];
        if (each.a == b || each.b == b || each.c == b) found.push_back(t);
    });
    std::reverse(found.begin(), found.end());
    return found;
}

std::optional<std::uint32_t> MeshIndex::find(std::span<const Triangle> all,
                                             const Triangle& triangle) const {
    const Selection wanted = Selection::ofTriangle(triangle);
    std::optional<std::uint32_t> found;
    forEachAt(triangle.a, [&](std::uint32_t t) {
        if (Selection::ofTriangle(all[t]) == wanted) found = t;
    });
    return found;
}

}  // namespace se::view
