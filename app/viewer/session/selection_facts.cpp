#include "selection_facts.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "session.h"
#include "spiraling_edge/base/lists.h"

namespace se::view {

namespace {

std::string ringWith(const std::vector<RingPath>& rings, const Selection& edge) {
    for (const RingPath& ring : rings) {
        for (std::size_t i = 0; i < ring.points.size(); ++i) {
            const Index to = ring.points[(i + 1) % ring.points.size()];
            if (!(Selection::ofEdge(ring.points[i], to) == edge)) continue;
            return ringName(ring.number) + (ring.active ? ", active" : ", on the stack");
        }
    }
    return {};
}

bool hasCorner(const Triangle& t, Index p) { return t.a == p || t.b == p || t.c == p; }

bool hasTriangle(const std::vector<Triangle>& mesh, const Selection& triangle) {
    return std::any_of(mesh.begin(), mesh.end(), [&](const Triangle& each) {
        return Selection::ofTriangle(each) == triangle;
    });
}

void addEdge(const Session& session, const Selection& edge, SelectionFacts& facts) {
    const PointSet& points = session.shown().points;
    const Index a = edge.points[0];
    const Index b = edge.points[1];
    facts.length = glm::length(points.position[b] - points.position[a]);
    facts.ring = ringWith(session.picture().rings, edge);
    facts.triangles = session.meshIndex().atEdge(session.triangles(), a, b);
    const std::span<const Triangle> shown = session.shownTriangles();
    facts.trianglesPresent =
        session.picture().repaired
            ? countWhere(shown,
                         [&](const Triangle& t) { return hasCorner(t, a) && hasCorner(t, b); })
            : countWhere(facts.triangles, [&](std::uint32_t t) { return t < shown.size(); });
    if (!facts.triangles.empty()) facts.number = facts.triangles.front();
    facts.present = facts.trianglesPresent > 0 || !facts.ring.empty();
}

void addTriangle(const Session& session, const Selection& triangle, SelectionFacts& facts) {
    const PointSet& points = session.shown().points;
    facts.degrees = cornerDegrees(points, triangle.triangle());
    facts.area = triangleArea(points, triangle.triangle());
    facts.number = session.meshIndex().find(session.triangles(), triangle.triangle());
    const auto& repaired = session.picture().repaired;
    facts.present = repaired ? hasTriangle(*repaired, triangle)
                             : facts.number && *facts.number < session.shownTriangles().size();
}

}  // namespace

SelectionFacts factsOf(const Session& session, const Selection& selection) {
    assert(session.ready());
    SelectionFacts facts;
    facts.present = selection.kind == SelectionKind::Point;
    if (selection.kind == SelectionKind::Edge) addEdge(session, selection, facts);
    if (selection.kind == SelectionKind::Triangle) addTriangle(session, selection, facts);
    return facts;
}

const SelectionFacts& FactsCache::of(const Session& session) {
    if (known_[0].session != &session) std::swap(known_[0], known_[1]);
    Known& known = known_[0];
    if (known.session == &session && known.revision == session.revision()) return known.facts;
    known = {&session, session.revision(), factsOf(session, session.selection())};
    return known.facts;
}

std::optional<std::uint32_t> pivotOfTriangle(const RunOverview& run, std::size_t number) {
    const auto found = std::upper_bound(run.triangles.begin(), run.triangles.end(), number);
    if (found == run.triangles.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - run.triangles.begin()) + 1;
}

std::optional<Address> originOfTriangle(const RunOverview& run, std::size_t number) {
    const std::optional<std::uint32_t> pivot = pivotOfTriangle(run, number);
    if (!pivot) return std::nullopt;
    const std::size_t before = *pivot > 1 ? run.triangles[*pivot - 2] : 0;
    return Address{*pivot, Stage::Emit, static_cast<std::uint32_t>(number - before + 1)};
}

}  // namespace se::view
