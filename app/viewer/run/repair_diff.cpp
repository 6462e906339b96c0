// The steps after the last pivot edit the mesh in place, so that creation order no longer
// identifies a triangle. The difference of two steps is a difference of lists in which few entries
// changed; the component of a triangle follows from its corners, since no edit joins two
// components.
#include "repair_diff.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "spiraling_edge/mesh/mesh_compare.h"
#include "strings.h"

namespace se::view {

namespace {

MeshEdge edgeOf(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

std::set<MeshEdge> edgesIn(std::span<const Triangle> triangles) {
    std::set<MeshEdge> edges;
    for (const Triangle& t : triangles) {
        edges.insert({edgeOf(t.a, t.b), edgeOf(t.b, t.c), edgeOf(t.c, t.a)});
    }
    return edges;
}

}  // namespace

MeshEdges edgesOf(std::span<const Triangle> gone, std::span<const Triangle> made, Index seated) {
    const std::set<MeshEdge> before = edgesIn(gone);
    const std::set<MeshEdge> after = edgesIn(made);
    MeshEdges edges;
    for (const MeshEdge& edge : after) {
        const bool wasThere = before.contains(edge) || (gone.empty() && seated != kNone &&
                                                        edge[0] != seated && edge[1] != seated);
        (wasThere ? edges.kept : edges.made).push_back(edge);
    }
    for (const MeshEdge& edge : before) {
        if (!after.contains(edge)) edges.gone.push_back(edge);
    }
    return edges;
}

MeshChange changeOf(std::span<const Vec3> position, std::span<const Triangle> before,
                    std::span<const Triangle> after) {
    const MeshDifference difference = compareMeshes(position, before, after);
    const auto differing = [](std::span<const Triangle> mesh, const std::vector<Match>& match) {
        std::vector<Triangle> list;
        for (std::size_t i = 0; i < mesh.size(); ++i) {
            if (match[i] != Match::Same) list.push_back(mesh[i]);
        }
        return std::make_shared<const std::vector<Triangle>>(std::move(list));
    };
    auto gone = differing(before, difference.a);
    auto made = differing(after, difference.b);
    MeshEdges edges = edgesOf(*gone, *made);
    return {std::move(gone), std::move(made),     std::move(edges),
            before.size(),   difference.reversed, difference.regions.size()};
}

std::array<std::string, 2> wordsOf(const MeshChange& change) {
    const std::string turn = change.turned > 0 ? ", " + grouped(change.turned) + " turn" : "";
    return {grouped(change.gone->size() - change.turned) + " of " + grouped(change.before) +
                " triangles go",
            grouped(change.made->size() - change.turned) + " come" + turn + ", in " +
                withS(change.regions, "region")};
}

std::vector<ComponentStretch> componentsOf(std::span<const Triangle> repaired,
                                           std::span<const Triangle> emitted,
                                           std::span<const std::size_t> starts,
                                           std::size_t points) {
    constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> of(points, kUnknown);
    std::size_t component = 0;
    for (std::size_t i = 0; i < emitted.size(); ++i) {
        while (component + 1 < starts.size() && starts[component + 1] <= i) ++component;
        for (const Index p : {emitted[i].a, emitted[i].b, emitted[i].c}) {
            if (of[p] == kUnknown) of[p] = component;
        }
    }
    std::vector<ComponentStretch> stretches;
    for (std::size_t i = 0; i < repaired.size(); ++i) {
        // The latest of its corners: a corner shared by two components belongs to the earlier one.
        // A point that was put in has none yet, and takes that of its triangle.
        std::size_t mine = 0;
        const std::array corners = {repaired[i].a, repaired[i].b, repaired[i].c};
        for (const Index p : corners) mine = of[p] == kUnknown ? mine : std::max(mine, of[p]);
        for (const Index p : corners) of[p] = of[p] == kUnknown ? mine : of[p];
        if (stretches.empty() || stretches.back().component != mine) stretches.push_back({i, mine});
    }
    return stretches;
}

const std::vector<ComponentStretch>& RepairedComponents::of(
    const std::shared_ptr<const std::vector<Triangle>>& repaired, std::span<const Triangle> emitted,
    std::span<const std::size_t> starts, std::size_t points) {
    if (repaired_ != repaired ||
        !std::equal(starts.begin(), starts.end(), starts_.begin(), starts_.end())) {
        repaired_ = repaired;
        starts_.assign(starts.begin(), starts.end());
        stretches_ = repaired ? componentsOf(*repaired, emitted, starts, points)
                              : std::vector<ComponentStretch>{};
    }
    return stretches_;
}

}  // namespace se::view
