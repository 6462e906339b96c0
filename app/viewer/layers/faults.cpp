/// Faults of the finished mesh: faulty triangles filled, loops bold, points in no triangle marked,
/// and the number of each of the first places; and the triangles that a fix would change.
#include <algorithm>
#include <string>

#include "layer.h"

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

}  // namespace se::view
