// Mesh triangles in three stretches: finished ones, the last fan, and those of the repair passes.

#include <algorithm>

#include "layer.h"

namespace se::view {

namespace {

/// The triangles of the last pivot that made any: those at the end with the same first corner.
std::span<const Triangle> lastFan(std::span<const Triangle> finished) {
    std::size_t begin = finished.size();
    while (begin > 0 && finished[begin - 1].a == finished.back().a) --begin;
    return finished.subspan(begin);
}

/// When a new fan appears, the previous one joins the finished triangles.
void addFadingFan(const LayerInput& in, DrawList& out) {
    const DecisionState& p = in.picture;
    const bool emits = p.event && p.event->address.stage == Stage::Emit;
    const bool lasts = in.moment.kind == Moment::Kind::Moving && p.complete;
    const float strength = fadeStrength(in.moment, 0.0F);
    if (!(emits || lasts) || p.newTriangles.empty() || !(strength > 0.0F)) return;
    const std::size_t count = std::min(p.finishedTriangles, in.triangles.size());
    const std::span<const Triangle> fan = lastFan(in.triangles.first(count));
    for (const Triangle& t : fan) {
        out.faces.push_back(
            {in.cornersOf(t), mix(in.palette.mesh, in.palette.test, 0.85F * strength), false});
    }
    if (in.moment.kind != Moment::Kind::Paper || fan.empty()) return;
    out.label(in.middleOf(fan.back()), "previous fan", in.palette.textDim);
}

/// One stretch per component; in the repaired mesh they alternate.
void addComponentColors(const LayerInput& in, DrawList& out) {
    if (in.picture.repaired) {
        for (const ComponentStretch& stretch : in.mesh.repaired) {
            out.meshStretches.push_back({stretch.first, componentColor(stretch.component)});
            out.components = std::max(out.components, stretch.component + 1);
        }
        return;
    }
    for (std::size_t i = 0; i < in.mesh.starts.size(); ++i) {
        out.meshStretches.push_back({in.mesh.starts[i], componentColor(i)});
        if (i == 0 || in.mesh.starts[i] < in.picture.finishedTriangles) out.components = i + 1;
    }
}

}  // namespace

void addTriangles(const LayerInput& in, DrawList& out) {
    out.meshVisible = true;
    out.finishedTriangles = in.picture.finishedTriangles;
    out.meshColor = in.palette.mesh;
    out.meshEdgeColor = in.mesh.style == MeshStyle::Wire ? in.palette.done : in.palette.meshEdge;
    // The repaired mesh has no creation order, but its triangles have their components.
    const bool ordered = in.picture.repaired == nullptr;
    const bool byCreation = in.mesh.style == MeshStyle::CreationOrder;
    out.meshStyle = ordered || !byCreation ? in.mesh.style : MeshStyle::Flat;
    out.creationEnd = in.mesh.creationEnd;
    addComponentColors(in, out);
    // New triangles are among them; those drawn below cover them.
    out.repaired = in.picture.repaired;
    if (ordered && in.mesh.style < MeshStyle::Wire) addFadingFan(in, out);
    if (in.faults != nullptr) addFaults(in, out);
    if (in.change != nullptr) addChange(in, out);
    // Triangles of the repair steps are drawn by addRepairs().
    if (!ordered) return;
    for (const Triangle& t : in.picture.newTriangles) {
        out.faces.push_back({in.cornersOf(t), in.palette.test, true});
    }
}

void addMeshEdges(const LayerInput&, DrawList& out) { out.meshEdges = true; }

// A component begins with a ring of two or a stranded point (§4); it is complete, or a ring was
// freed along the rim of the surface (§3, §7).

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
