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
    const bool byBirth = in.mesh.style == MeshStyle::CreationOrder;
    out.meshStyle = ordered || !byBirth ? in.mesh.style : MeshStyle::Flat;
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

}  // namespace se::view
