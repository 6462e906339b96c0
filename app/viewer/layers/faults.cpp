/// Faults of the finished mesh: faulty triangles filled, loops bold, points in no triangle marked,
/// and the number of each of the first places.
#include <algorithm>
#include <string>

#include "layer.h"

namespace se::view {

namespace {

/// Places with a number in the view: those that a user walks to first.
constexpr std::size_t kMaxNumbered = 20;
/// Marks and filled triangles: of a tangled mesh more would not be told apart.
constexpr std::size_t kMaxMarks = 20'000;

/// Opaque, and so near that a color is told apart from that of the mesh.
void addTriangle(const LayerInput& in, Index number, const Color& color, DrawList& out) {
    const std::span<const Triangle> mesh =
        in.picture.repaired ? std::span<const Triangle>(*in.picture.repaired) : in.triangles;
    if (number < mesh.size()) out.faces.push_back({in.cornersOf(mesh[number]), color, false});
}

void addLoop(const LayerInput& in, const MeshFailure& loop, const Color& color, DrawList& out) {
    const std::span<const Triangle> mesh =
        in.picture.repaired ? std::span<const Triangle>(*in.picture.repaired) : in.triangles;
    const auto isOn = [&](Index p) {
        return std::binary_search(loop.points.begin(), loop.points.end(), p);
    };
    // A triangle at the loop has one side on it, or several.
    std::vector<std::pair<Index, Index>> sides;
    for (const Index number : loop.triangles) {
        if (number >= mesh.size()) continue;
        const Triangle& t = mesh[number];
        for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
            if (isOn(u) && isOn(v)) sides.emplace_back(std::min(u, v), std::max(u, v));
        }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        // A side of two triangles joins two parts of the loop, and is not on it.
        if (i + 1 < sides.size() && sides[i] == sides[i + 1]) {
            ++i;
            continue;
        }
        out.line(in.at(sides[i].first), in.at(sides[i].second), color, 0.28F, Depth::XRay);
    }
}

}  // namespace

void addFaults(const LayerInput& in, DrawList& out) {
    std::size_t left = kMaxMarks;
    for (const MeshFailure& each : in.faults->all) {
        if (left == 0) break;
        if (isLoop(each)) {
            addLoop(in, each, each.kind->fault ? in.palette.rejected : in.palette.textDim, out);
            --left;
        } else if (each.kind->fault && each.triangles.empty()) {
            for (const Index p : each.points) {
                if (in.model.drawable[p])
                    out.mark(in.at(p), Shape::OpenDiamond, in.palette.rejected, 0.7F);
            }
            left -= std::min(left, each.points.size());
        } else if (each.kind->fault) {
            for (const Index number : each.triangles)
                addTriangle(in, number, in.palette.rejected, out);
            left -= std::min(left, each.triangles.size());
        }
    }
    const std::size_t numbered = std::min(in.faults->places.size(), kMaxNumbered);
    for (std::size_t i = 0; i < numbered; ++i) {
        out.label(in.model.toView(in.faults->places[i].center), std::to_string(i + 1),
                  in.palette.rejected, true);
    }
}

}  // namespace se::view
