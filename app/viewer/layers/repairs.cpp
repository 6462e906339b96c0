/// Beyond the paper (docs/robust.md): the effect of the steps after the last pivot on the mesh.
#include "layer.h"
#include "run/number_format.h"
#include "run/repair_diff.h"
#include "run/strings.h"
#include "scene/selection_measures.h"

namespace se::view {

namespace {

/// Old edges dashed, new ones bold, the rim thin. New triangles are hatched besides.
void addEdges(const LayerInput& in, const MeshEdges& edges, DrawList& out) {
    const Palette& c = in.palette;
    for (const MeshEdge& e : edges.kept) {
        out.line(in.at(e[0]), in.at(e[1]), c.test, 0.14F, Depth::OnTop);
    }
    for (const MeshEdge& e : edges.gone) out.dashed(in.at(e[0]), in.at(e[1]), c.text, 0.24F, 0.4F);
    for (const MeshEdge& e : edges.made) {
        out.line(in.at(e[0]), in.at(e[1]), c.used, 0.3F, Depth::OnTop);
    }
}

void addPoint(const LayerInput& in, Index point, const std::string& text, Shape shape,
              const Color& color, DrawList& out) {
    out.mark(in.at(point), shape, color, 1.0F);
    out.label(in.at(point), text, color, true);
}

std::string leastAngles(const LayerInput& in) {
    const DecisionState& p = in.picture;
    const std::string after = degreesText(leastDegrees(in.model.points, p.newTriangles));
    if (p.goneTriangles.empty()) return "least angle " + after;
    return "least angle " + degreesText(leastDegrees(in.model.points, p.goneTriangles)) +
           " \xE2\x86\x92 " + after;
}

void addFlip(const LayerInput& in, const FlipEvidence& e, DrawList& out) {
    const Palette& c = in.palette;
    addEdges(in, edgesOf(in.picture.goneTriangles, in.picture.newTriangles), out);
    for (const Index point : {e.u, e.v, e.x, e.y})
        addPoint(in, point, nameOf(point, in.names), Shape::Disc,
                 point == e.u || point == e.v ? c.rejected : c.used, out);
    // Beside the figure: the names are within it.
    out.label(in.middleOf(e.v, e.x), leastAngles(in), c.used, true);
}

const char* wayOf(const DecisionState& picture, const MeshEdges& edges) {
    if (picture.goneTriangles.empty()) return "joins the border";
    if (edges.gone.empty()) return "splits its triangle";
    return edges.gone.size() == 1 ? "splits an edge" : "replaces triangles";
}

void addReinsert(const LayerInput& in, const ReinsertEvidence& e, DrawList& out) {
    const DecisionState& p = in.picture;
    const MeshEdges edges = edgesOf(p.goneTriangles, p.newTriangles, e.point);
    // The triangles that it is put into, before the step.
    for (const Triangle& t : p.goneTriangles) {
        out.sheet(in.at(t.a), in.at(t.b), in.at(t.c), in.palette.text.withAlpha(0.16F));
    }
    addEdges(in, edges, out);
    addPoint(in, e.point, nameOf(e.point, in.names) + " " + wayOf(p, edges), Shape::RingedDisc,
             in.palette.pivot, out);
    if (!edges.kept.empty()) {
        out.label(in.middleOf(edges.kept.front()[0], edges.kept.front()[1]), leastAngles(in),
                  in.palette.used, true);
    }
}

void addRemoveFolded(const LayerInput& in, const RemoveFoldedEvidence& e, DrawList& out) {
    const DecisionState& p = in.picture;
    const MeshEdges edges = edgesOf(p.goneTriangles, p.newTriangles);
    addEdges(in, edges, out);
    addPoint(in, e.point, nameOf(e.point, in.names) + " taken out", Shape::Cross,
             in.palette.rejected, out);
    if (!edges.kept.empty()) {
        out.label(in.middleOf(edges.kept.front()[0], edges.kept.front()[1]),
                  std::to_string(p.goneTriangles.size()) + " triangles \xE2\x86\x92 " +
                      std::to_string(p.newTriangles.size()),
                  in.palette.used, true);
    }
}

void addCloseHole(const LayerInput& in, const CloseHoleEvidence& e, DrawList& out) {
    addEdges(in, edgesOf(in.picture.goneTriangles, in.picture.newTriangles), out);
    out.label(in.middleOf(e.first, e.second), "hole of " + std::to_string(e.length) + " filled",
              in.palette.used, true);
}

void addRemesh(const LayerInput& in, const RemeshEvidence& e, DrawList& out) {
    addEdges(in, edgesOf(in.picture.goneTriangles, in.picture.newTriangles), out);
    out.label(in.middleOf(e.faulty.a, e.faulty.b), leastAngles(in), in.palette.used, true);
}

void addDropPatch(const LayerInput& in, const DropPatchEvidence& e, DrawList& out) {
    addEdges(in, edgesOf(in.picture.goneTriangles, in.picture.newTriangles), out);
    addPoint(in, e.point, counted(e.triangles, "triangle", "triangles") + " taken out",
             Shape::Cross, in.palette.rejected, out);
}

}  // namespace

void addRepairs(const LayerInput& in, DrawList& out) {
    const DecisionState& p = in.picture;
    if (p.repaired) {
        for (const Triangle& t : p.newTriangles)
            out.faces.push_back({in.cornersOf(t), in.palette.test, true});
    }
    if (const auto* flip = p.evidence<FlipEvidence>(Stage::Flip)) addFlip(in, *flip, out);
    if (const auto* put = p.evidence<ReinsertEvidence>(Stage::Reinsert)) addReinsert(in, *put, out);
    if (const auto* hole = p.evidence<CloseHoleEvidence>(Stage::CloseHole))
        addCloseHole(in, *hole, out);
    if (const auto* patch = p.evidence<DropPatchEvidence>(Stage::DropPatch))
        addDropPatch(in, *patch, out);
    if (const auto* faulty = p.evidence<RemeshEvidence>(Stage::Remesh)) addRemesh(in, *faulty, out);
    if (const auto* taken = p.evidence<RemoveFoldedEvidence>(Stage::RemoveFolded))
        addRemoveFolded(in, *taken, out);
}

}  // namespace se::view
