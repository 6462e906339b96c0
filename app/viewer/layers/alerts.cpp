/// Failures: the chosen alert, and the failures caused by this decision.
#include <algorithm>

#include "layer.h"

namespace se::view {

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

/// Filled if it is made already, otherwise dashed.
void addTriangle(const LayerInput& in, const Triangle& t, bool there, DrawList& out) {
    const Color& color = in.palette.rejected;
    if (there) out.sheet(in.at(t.a), in.at(t.b), in.at(t.c), color.withAlpha(kTint));
    for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
        out.dashed(in.at(u), in.at(v), color, 0.16F, there ? 0.0F : 0.3F);
    }
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

}  // namespace se::view
