/// A component begins with a ring of two or a stranded point (§4); it is complete, or a ring was
/// freed along the rim of the surface (§3, §7).
#include <algorithm>

#include "layer.h"

namespace se::view {

namespace {

/// The freed ring, bold: an open border, or in the color of errors if it should not be open.
void addFreedRing(const LayerInput& in, const FreedRingState& ring, bool named, DrawList& out) {
    const std::vector<Index>& points = ring.path.points;
    if (points.empty()) return;
    const Color& color = ring.alert ? in.palette.rejected : in.palette.last;
    // Errors must not be hidden by correct parts.
    const Depth depth = ring.alert ? Depth::OnTop : Depth::XRay;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec3& from = in.at(points[i]);
        const glm::vec3& to = in.at(points[(i + 1) % points.size()]);
        // A step that is no mesh edge bounds nothing.
        ring.path.open[i] ? out.dashed(from, to, color, 0.2F, 0.3F)
                          : out.line(from, to, color, 0.36F, depth);
    }
    if (!named) return;
    std::string text = "ring of " + std::to_string(points.size()) + " freed";
    if (!ring.evidence) text = "a ring of " + std::to_string(points.size()) + " is freed";
    if (ring.alert == AlertKind::Hole) text += ": a hole stays open";
    const bool failedSeed = ring.evidence && ring.evidence->seed;
    if (ring.alert == AlertKind::LostSeed || failedSeed) text += ": its seed got no triangle";
    out.label(in.at(points.front()), text, color, true);
}

/// Limit of marks, since more would hide the scene.
constexpr std::size_t kDotsUpTo = 20'000;

/// Position of a point in the order in which the search for a start visits them.
std::size_t placeOf(const PointSet& points, Index point) {
    if (points.order.empty()) return point;
    const auto found = std::find(points.order.begin(), points.order.end(), point);
    return static_cast<std::size_t>(found - points.order.begin());
}

/// A DONE point that the search skipped, highlighted.
void addPassed(const LayerInput& in, Index point, float strength, DrawList& out) {
    if (!in.model.drawable[point]) return;
    const Color color = mix(in.palette.done, in.palette.text, strength);
    out.mark(in.at(point), Shape::Dot, color, 0.3F + 0.2F * strength);
}

/// The points that the search for a start has skipped since the last ring began, all DONE; and the
/// nearer neighbors of the start point, which are DONE as well.
void addPassedPoints(const LayerInput& in, const SeedEvidence& e, DrawList& out) {
    const float strength = blinkStrength(in.moment);
    if (!(strength > 0.0F)) return;
    const PointSet& points = in.model.points;
    const std::size_t end = std::min(placeOf(points, e.first), points.size());
    std::size_t begin = in.seedBefore == kNone ? 0 : placeOf(points, in.seedBefore);
    if (end > kDotsUpTo) begin = std::max(begin, end - kDotsUpTo);
    std::size_t passed = 0;
    for (std::size_t i = begin; i < end; ++i) {
        const Index point = points.inOrder(i);
        if (in.picture.status[point] != kDone) continue;
        addPassed(in, point, strength, out);
        ++passed;
    }
    for (const Index q : points.neighbors[e.first]) {
        if (q == e.second) break;
        addPassed(in, q, strength, out);
        out.label(in.at(q), "DONE", in.palette.textDim);
    }
    if (passed == 0) return;
    out.label(in.at(points.inOrder(begin)), std::to_string(passed) + " DONE, passed over",
              in.palette.text);
}

}  // namespace

void addComponent(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<ComponentEvidence>(Stage::Done);
    if (in.picture.freed) addFreedRing(in, *in.picture.freed, e == nullptr, out);
    if (e == nullptr) return;
    const std::size_t end = e->triangles;
    // Where colors show components, or the creation order, it has its color.
    if (in.mesh.style < MeshStyle::CreationOrder && in.picture.repaired == nullptr) {
        const Color tint = mix(in.palette.mesh, in.palette.used, 0.55F);
        out.meshStretches.push_back({std::min(in.componentBegin, end), tint});
        out.meshStretches.push_back({end, out.meshColor});
    }
    if (in.component == nullptr) return;
    for (const auto& [from, to] : in.component->rim) {
        out.line(in.at(from), in.at(to), in.palette.last, 0.26F, Depth::XRay);
    }
    out.label(in.component->middle,
              "component " + std::to_string(e->component) + ": " +
                  std::to_string(in.component->end - in.component->begin) + " triangles",
              in.palette.text, true);
}

void addSeed(const LayerInput& in, DrawList& out) {
    const Palette& c = in.palette;
    if (const auto* strand = in.picture.evidence<StrandEvidence>(Stage::Strand)) {
        out.mark(in.at(strand->point), Shape::Cross, c.rejected, 1.1F);
        out.label(in.at(strand->point),
                  strand->isolated   ? "no neighbors listed"
                  : strand->unseeded ? "no seed left to try"
                                     : "no neighbor left",
                  c.rejected, true);
    }
    const auto* e = in.picture.evidence<SeedEvidence>(Stage::Seed);
    if (e == nullptr) return;
    addPassedPoints(in, *e, out);
    out.line(in.at(e->first), in.at(e->second), c.used, 0.3F, Depth::OnTop);
    out.mark(in.at(e->second), Shape::RingedDisc, c.used, 1.1F);
    out.mark(in.at(e->first), Shape::RingedDisc, c.pivot, 1.3F);
    out.label(in.at(e->first), "start point " + nameOf(e->first, in.names), c.pivot, true);
    out.label(in.at(e->second), nameOf(e->second, in.names) + ", its nearest not DONE", c.used,
              true);
    out.label(in.middleOf(e->first, e->second), "ring of two", c.used);
}

}  // namespace se::view
