/// Faults of the finished mesh: faulty triangles filled, loops bold, points in no triangle marked,
/// and the number of each of the first places; and the triangles that a fix would change.

#include <algorithm>
#include <array>
#include <string>

#include "disc.h"
#include "layer.h"
#include "run/repair_diff.h"
#include "run/selection.h"
#include "run/strings.h"

namespace se::view {

namespace {

/// Places with a number in the view: those that a user walks to first.
constexpr std::size_t kMaxNumbered = 20;
/// Marks and filled triangles: of a tangled mesh more would not be told apart.
constexpr std::size_t kMaxFaultMarks = 20'000;

void addFilled(const LayerInput& in, std::span<const Index> numbers, DrawList& out) {
    const std::span<const Triangle> mesh =
        in.picture.repaired ? std::span<const Triangle>(*in.picture.repaired) : in.triangles;
    for (const Index number : numbers) {
        if (number < mesh.size())
            out.faces.push_back({in.cornersOf(mesh[number]), in.palette.rejected, false});
    }
}

void addLoop(const LayerInput& in, const MeshFailure& loop, DrawList& out) {
    const Color& color = loop.kind->fault ? in.palette.rejected : in.palette.textDim;
    for (const auto& [u, v] : loop.edges) out.line(in.at(u), in.at(v), color, 0.28F, Depth::XRay);
}

}  // namespace

void addFaults(const LayerInput& in, DrawList& out) {
    std::size_t left = kMaxFaultMarks;
    for (const MeshFailure& each : in.faults->all) {
        if (left == 0) break;
        if (isLoop(each)) {
            addLoop(in, each, out);
            --left;
        } else if (each.kind->fault && each.triangles.empty()) {
            for (const Index p : each.points) {
                if (in.model.drawable[p])
                    out.mark(in.at(p), Shape::OpenDiamond, in.palette.rejected, 0.7F);
            }
            left -= std::min(left, each.points.size());
        } else if (each.kind->fault && in.change == nullptr) {
            addFilled(in, each.triangles, out);
            left -= std::min(left, each.triangles.size());
        }
    }
    const std::size_t numbered = std::min(in.faults->places.size(), kMaxNumbered);
    for (std::size_t i = 0; i < numbered; ++i) {
        const FaultPlace& place = in.faults->places[i];
        out.label(in.model.toView(place.center), std::to_string(i + 1), in.palette.rejected, true);
        // Smaller ones have a pin.
        out.labels.back().extent = sizeOnMesh(in.model, place);
    }
}

void addChange(const LayerInput& in, DrawList& out) {
    const MeshChange& change = *in.change;
    out.tinted = {TintedTriangles{change.gone, change.gone->size(), in.palette.rejected},
                  TintedTriangles{change.made, change.made->size(), in.palette.used}};
    // New triangles cover old ones: the edges of these are above them.
    for (const MeshEdge& e :
         std::span(change.edges.gone).first(std::min(change.edges.gone.size(), kMaxFaultMarks)))
        out.dashed(in.at(e[0]), in.at(e[1]), in.palette.text, 0.12F, 0.3F, Depth::Tested);
}

// Failures: the chosen alert, and the failures caused by this decision.

namespace {

constexpr float kTint = 0.5F;
/// Width of the outline of a hole.
constexpr float kOutline = 0.34F;
/// Limit of marks on the points of a large failure.
constexpr std::size_t kMaxMarks = 400;

bool isThere(const LayerInput& in, Index number) {
    if (in.picture.repaired) return true;
    return number < in.picture.finishedTriangles + in.picture.newTriangles.size();
}

/// Draws a triangle of a failure: filled if it is made already, otherwise dashed.
void addTriangle(const LayerInput& in, const Triangle& t, bool there, DrawList& out) {
    const Color& color = in.palette.rejected;
    if (there) out.sheet(in.at(t.a), in.at(t.b), in.at(t.c), color.withAlpha(kTint));
    out.loop(in.cornersOf(t), color, 0.16F, Depth::OnTop, there ? 0.0F : 0.3F);
}

void addMarkedPoints(const LayerInput& in, std::span<const Index> points, DrawList& out) {
    for (const Index p : points.first(std::min(points.size(), kMaxMarks))) {
        if (in.model.drawable[p])
            out.mark(in.at(p), Shape::OpenDiamond, in.palette.rejected, 0.95F);
    }
}

/// The triangles along a hole are correct, and so is the fan around a point.
bool showsTriangles(const MeshFailure& failure) { return !isLoop(failure); }

void addMarkedEdge(const LayerInput& in, std::span<const Index> points, DrawList& out) {
    out.line(in.at(points[0]), in.at(points[1]), in.palette.rejected, 0.5F, Depth::OnTop);
}

void addChosen(const LayerInput& in, const RunFailure& alert, DrawList& out) {
    const MeshFailure& failure = alert.failure;
    if (showsTriangles(failure)) {
        for (std::size_t i = 0; i < alert.corners.size(); ++i)
            addTriangle(in, alert.corners[i], isThere(in, failure.triangles[i]), out);
    }
    for (const auto& [u, v] : failure.edges)
        out.line(in.at(u), in.at(v), in.palette.rejected, kOutline, Depth::OnTop);
    const bool edge = failure.points.size() == 2 && !failure.triangles.empty();
    if (edge) addMarkedEdge(in, failure.points, out);
    // Corners of filled triangles need no marks.
    if (edge || failure.points.size() == 1 || !showsTriangles(failure) || failure.triangles.empty())
        addMarkedPoints(in, failure.points, out);
}

/// Failures at this event, in the color of errors, with their names.
void addNoticed(const LayerInput& in, const LiveFailure& failure, DrawList& out) {
    for (const Index number : {failure.triangle, failure.other}) {
        if (number != kNone && number < in.triangles.size())
            addTriangle(in, in.triangles[number], true, out);
    }
    if (failure.triangle == kNone || failure.points.size() == 2)
        addMarkedPoints(in, failure.points, out);
    if (failure.points.size() == 2) addMarkedEdge(in, failure.points, out);
}

}  // namespace

void addAlerts(const LayerInput& in, DrawList& out) {
    if (in.alert != nullptr) addChosen(in, *in.alert, out);
    if (in.finished) return;  // All faults are shown, not those of the last event.
    for (const LiveFailure& each : in.noticed) addNoticed(in, each, out);
    if (in.noticed.empty()) return;
    const LiveFailure& first = in.noticed.front();
    glm::vec3 middle(0.0F);
    for (const Index p : first.points) middle += in.at(p) / static_cast<float>(first.points.size());
    std::string text(first.kind->name);
    std::replace(text.begin(), text.end(), '_', ' ');
    out.label(middle, "! " + text, in.palette.rejected, true);
}

// Holes: the plane of a hole of three (§6.2, Fig. 7), and, beyond the paper (RobustRules::fill),
// the ears that close a larger one, the largest least angle first.

namespace {

void addPlane(const LayerInput& in, const glm::vec3& up, DrawList& out) {
    const glm::vec3 s = in.at(in.picture.start);
    const glm::vec3 e = in.at(in.picture.end);
    const glm::vec3 beyond = 0.25F * (e - s);
    const glm::vec3 rise = 0.9F * in.model.spacing * up;
    const std::array corners = {s - beyond - rise, e + beyond - rise, e + beyond + rise,
                                s - beyond + rise};
    const Color& color = in.palette.test;
    out.sheet(corners, color.withAlpha(0.3F));
    out.loop(corners, color, 0.1F);
    out.arrow(0.5F * (s + e), 0.5F * (s + e) + 1.4F * rise, color, 0.12F);
    out.label(0.5F * (s + e) + 1.4F * rise, "mean normal", color);
}

void addFeet(const LayerInput& in, const Disc& plane, float pivotSide, DrawList& out) {
    for (const CandidateMark& mark : in.picture.candidates) {
        if (mark.state == CandidateState::Rejected && mark.stage != Stage::Hole) continue;
        const glm::vec3 at = in.at(mark.point);
        // Those that are not tested yet, by their side.
        const bool far = glm::dot(at - plane.origin, plane.normal) * pivotSide <= 0.0F;
        const bool refused =
            mark.stage == Stage::Hole ? mark.state == CandidateState::Rejected : far;
        const Color& color = refused ? in.palette.rejected : in.palette.used;
        out.dashed(at, plane.foot(at), color, 0.1F, 0.2F);
        out.mark(plane.foot(at), Shape::Dot, color, 0.4F);
    }
}

/// The rim of the hole, bold.
void addHole(const LayerInput& in, const FillEvidence& e, DrawList& out) {
    const std::vector<RingPath>& rings = in.picture.rings;
    if (rings.empty() || !rings.front().active || rings.front().points.empty()) return;
    const std::vector<Index>& points = rings.front().points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.line(in.at(points[i]), in.at(points[(i + 1) % points.size()]), in.palette.last, 0.28F,
                 Depth::XRay);
    }
    // Away from the ear, which has labels of its own.
    const auto ear = std::find(points.begin(), points.end(), e.pivot) - points.begin();
    const std::size_t away = (static_cast<std::size_t>(ear) + points.size() / 2) % points.size();
    out.label(in.at(points[away]), "hole of " + std::to_string(e.ringLength), in.palette.last,
              true);
}

}  // namespace

void addHolePlane(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<HoleEvidence>(Stage::Hole);
    const DecisionState& picture = in.picture;
    if (e == nullptr || picture.pivot == kNone || picture.start == kNone) return;
    const glm::vec3 normal(e->planeNormal);
    if (!(glm::length(normal) > 0.0F)) return;
    const glm::vec3 p = in.at(picture.pivot);
    const glm::vec3 s = in.at(picture.start);
    const glm::vec3 end = in.at(picture.end);
    const Disc plane{s, glm::normalize(normal), {}, {}};
    const glm::vec3 up = glm::normalize(glm::cross(plane.normal, end - s));
    const float way = glm::dot(up, in.model.normal[picture.pivot]) < 0.0F ? -1.0F : 1.0F;
    const Palette& c = in.palette;
    out.sheet(p, s, end, c.used.withAlpha(0.35F));
    out.loop(std::array{p, s, end}, c.used, 0.16F);
    out.label((p + s + end) / 3.0F, "side of the pivot", c.used, true);
    addPlane(in, way * up, out);
    addFeet(in, plane, glm::dot(p - s, plane.normal), out);
    if (e->point == kNone) return;
    const bool near = e->side * e->pivotSide > 0.0;
    out.label(0.5F * (in.at(e->point) + plane.foot(in.at(e->point))),
              (near ? "near" : "far") + formatted(" side, %.3g off", std::abs(e->side)),
              verdictColor(e->verdict, c), true);
    if (isWhatIf(e->verdict)) addVerdict(e->verdict, in.at(e->point), c, out);
}

void addHoleFill(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<FillEvidence>(Stage::Fill);
    if (e == nullptr || e->first == kNone || e->last == kNone) return;
    const Palette& c = in.palette;
    const glm::vec3& p = in.at(e->pivot);
    const glm::vec3& first = in.at(e->first);
    const glm::vec3& last = in.at(e->last);
    addHole(in, *e, out);
    out.sheet(p, first, last, c.test.withAlpha(0.25F));
    out.hatch(first, last, p, c.test, 9);
    out.line(first, last, c.test, 0.26F, Depth::OnTop);
    out.label(
        0.5F * (first + last),
        (e->forced ? "no ear without a fault: " : "best ear: ") + degreesText(e->leastDegrees),
        e->forced ? c.rejected : c.test, true);
}

// Beyond the paper (docs/robust.md): the effect of the steps after the last pivot on the mesh.

namespace {

/// Draws edges: old ones dashed, new ones bold, the rim thin. New triangles are hatched besides.
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
}

}  // namespace se::view
