/// §3, §7: a component is complete, or a ring was freed along the rim of the surface.
#include <algorithm>
#include <vector>

#include "layer.h"

namespace se::view {

namespace {

/// Above this many triangles the whole mesh is tinted: finding the component's rim would take
/// longer than a frame.
constexpr std::size_t kOneByOneUpTo = 40'000;

std::uint64_t edgeKey(Index from, Index to) { return std::uint64_t{from} << 32U | to; }

/// Directed edges without a partner in the other direction.
void addRim(const LayerInput& in, std::span<const Triangle> triangles, DrawList& out) {
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) {
        edges.insert(edges.end(), {edgeKey(t.a, t.b), edgeKey(t.b, t.c), edgeKey(t.c, t.a)});
    }
    std::sort(edges.begin(), edges.end());
    for (const std::uint64_t edge : edges) {
        const auto from = static_cast<Index>(edge >> 32U);
        const auto to = static_cast<Index>(edge);
        if (std::binary_search(edges.begin(), edges.end(), edgeKey(to, from))) continue;
        out.line(in.at(from), in.at(to), in.palette.last, 0.26F, Depth::XRay);
    }
}

void addFreedRing(const LayerInput& in, const FreeEvidence& e, DrawList& out) {
    if (in.picture.oldRings.empty() || !in.picture.oldRings.front().active) return;
    const std::vector<Index>& points = in.picture.oldRings.front().points;
    if (points.empty()) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.dashed(in.at(points[i]), in.at(points[(i + 1) % points.size()]), in.palette.last, 0.26F,
                   0.6F, Depth::XRay);
    }
    out.label(in.at(points.front()), "ring of " + std::to_string(e.length) + " freed",
              in.palette.last, true);
}

}  // namespace

void addComponent(const LayerInput& in, DrawList& out) {
    if (const auto* freed = in.picture.evidence<FreeEvidence>(Stage::Done)) {
        addFreedRing(in, *freed, out);
    }
    const auto* e = in.picture.evidence<ComponentEvidence>(Stage::Done);
    if (e == nullptr) return;
    const Color tint = mix(in.palette.mesh, in.palette.used, 0.55F);
    const std::size_t end = std::min<std::size_t>(e->triangles, in.triangles.size());
    const std::size_t begin = std::min(in.componentBegin, end);
    if (end - begin > kOneByOneUpTo) {
        out.meshColor = tint;
        return;
    }
    const auto triangles = in.triangles.subspan(begin, end - begin);
    glm::vec3 middle(0.0F);
    for (const Triangle& t : triangles) {
        out.faces.push_back({{in.at(t.a), in.at(t.b), in.at(t.c)}, tint, false});
        middle += in.at(t.a) / static_cast<float>(triangles.size());
    }
    addRim(in, triangles, out);
    out.label(middle,
              "component " + std::to_string(e->component) + ": " +
                  std::to_string(triangles.size()) + " triangles",
              in.palette.text, true);
}

}  // namespace se::view
