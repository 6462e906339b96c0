/// Spikes: triangles that reach where no surface is, by the distances of the points as given.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "spiraling_edge/mesh/inspection_checks.h"

namespace se::inspect {
namespace {

/// An edge longer than this many times the reach of the 12 nearest points of either end is a spike,
/// unless it closes a hole. Reaches count, since spacings differ much where points lie in clusters.
constexpr double kSpike = 5.0;

}  // namespace

void spikes(const InspectedMesh& mesh, Failures& failures) {
    if (mesh.judge == nullptr || mesh.judge->reach.empty()) return;
    const MeshJudge& judge = *mesh.judge;
    const std::vector<bool> ends = endsOf(judge);
    const auto isLong = [&](Index p, Index q) {
        const double reach = std::max(judge.reach[p], judge.reach[q]);
        return !(ends[p] && ends[q]) &&
               glm::distance(mesh.points.position[p], mesh.points.position[q]) > kSpike * reach;
    };
    const auto isStray = [&](Index p) { return MeshJudge::isMarked(judge.stray, p); };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const bool spike = isStray(t.a) || isStray(t.b) || isStray(t.c) || isLong(t.a, t.b) ||
                           isLong(t.b, t.c) || isLong(t.c, t.a);
        if (spike) failures.push_back(mesh.at({t.a, t.b, t.c}, {static_cast<Index>(i)}));
    }
}

}  // namespace se::inspect
