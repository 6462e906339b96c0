#include "spiraling_edge/mesh/mesh_judge.h"

#include <cmath>

namespace se {

std::vector<bool> endsOf(const MeshJudge& judge) {
    std::vector<bool> ends(judge.points.size(), false);
    for (Index p = 0; p < ends.size(); ++p) ends[p] = isBoundary(judge.points.type[p]);
    for (const std::vector<Index>& chain : judge.openings) {
        for (const Index p : chain) ends[p] = true;
    }
    return ends;
}

std::string departureText(const MeshJudge& judge) {
    const InputFacts& facts = judge.facts;
    if (facts.hasNormals && !facts.normalsFit) {
        return "by derived normals: the given ones are " +
               std::to_string(std::lround(facts.normalDegrees)) +
               " degrees off the surface (median)";
    }
    if (facts.flippedNormals == 0) return {};
    return facts.flippedNormals == 1
               ? "by the given normals, but for 1 that points against those around it"
               : "by the given normals, but for " + std::to_string(facts.flippedNormals) +
                     " that point against those around them";
}

}  // namespace se
