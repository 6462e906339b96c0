// The edge rings: the active one with arrow heads, those on the stack dashed, with their letters.
#include <algorithm>
#include <glm/geometric.hpp>

#include "layer.h"

namespace se::view {

namespace {

/// Steps shorter than this share of the median spacing get no arrow head of their own.
constexpr float kArrowShare = 0.5F;
/// Rings deeper on the stack are named only when chosen.
constexpr Index kNamesUpTo = 6;

void addRing(const LayerInput& in, const RingPath& ring, const Line& like, DrawList& out) {
    const std::size_t count = ring.points.size();
    // Long rings: an arrow head on every step would be clutter.
    const std::size_t arrowEvery = count > 240 ? 6 : count > 80 ? 3 : 1;
    for (std::size_t i = 0; i < count; ++i) {
        Line line = like;
        line.from = in.at(ring.points[i]);
        line.to = in.at(ring.points[(i + 1) % count]);
        const float length = glm::distance(line.from, line.to);
        if (i % arrowEvery != 0 || length < kArrowShare * in.model.spacing) line.arrow = 0.0F;
        if (ring.open[i]) {
            // No edge of the mesh: thin and dotted.
            line.width *= 0.6F;
            line.dash = 0.22F;
        }
        out.lines.push_back(line);
    }
}

/// The letter of a ring is at its first point.
void addName(const LayerInput& in, const RingPath& ring, DrawList& out) {
    if (ring.points.empty()) return;
    out.label(in.at(ring.points.front()), "ring " + ringName(ring.number), in.palette.used);
}

}  // namespace

void addEdgeRing(const LayerInput& in, DrawList& out) {
    for (const RingPath& ring : in.picture.rings) {
        if (!ring.active) continue;
        const bool lit = ring.id != kNone && ring.id == in.highlightedRing;
        const Color& color = lit ? in.palette.pivot : in.palette.used;
        addRing(in, ring, {{}, {}, color, lit ? 0.26F : 0.2F, 0.0F, 0.55F, Depth::XRay}, out);
    }
}

void addStackedRings(const LayerInput& in, DrawList& out) {
    for (const RingPath& ring : in.picture.rings) {
        if (ring.active) continue;
        const bool lit = ring.id != kNone && ring.id == in.highlightedRing;
        const Color& color = lit ? in.palette.pivot : in.palette.used;
        const float width = std::max(0.07F, 0.14F - 0.02F * static_cast<float>(ring.depth));
        addRing(in, ring, {{}, {}, color, width, 0.4F, 0.0F, Depth::XRay}, out);
        if (lit || ring.depth < kNamesUpTo) addName(in, ring, out);
    }
}

}  // namespace se::view
