/// Two meshes as sorted lists of corner triples, merged in one pass; triangles in only one of them
/// are joined by common points to regions (union-find). O(t log t). The vertices of a mesh from a
/// file are found among the points in a grid with about one point per cell: about O(1) per vertex.
#include "spiraling_edge/mesh/mesh_compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <set>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/points/wall_types.h"

namespace se {
namespace {

using Entry = SortedTriangle;

Entry entryOf(const Triangle& t, Index triangle) {
    Entry entry{{t.a, t.b, t.c}, false, triangle};
    for (const auto& [x, y] : {std::pair{0U, 1U}, {1U, 2U}, {0U, 1U}}) {
        if (entry.corners[x] <= entry.corners[y]) continue;
        std::swap(entry.corners[x], entry.corners[y]);
        entry.odd = !entry.odd;
    }
    return entry;
}

std::vector<Entry> sortedEntries(std::span<const Triangle> triangles) {
    std::vector<Entry> entries;
    entries.reserve(triangles.size());
    for (const Triangle& t : triangles)
        entries.push_back(entryOf(t, static_cast<Index>(entries.size())));
    std::sort(entries.begin(), entries.end());
    return entries;
}

/// Pairs triangles with the same corners: those of equal winding first, then the rest.
void pairTriangles(std::span<const Entry> a, std::span<const Entry> b, MeshDifference& found) {
    for (const bool alike : {true, false}) {
        for (const Entry& x : a) {
            if (found.a[x.triangle] != Match::Missing) continue;
            const auto y = std::find_if(b.begin(), b.end(), [&](const Entry& e) {
                return found.b[e.triangle] == Match::Missing && (e.odd == x.odd) == alike;
            });
            if (y == b.end()) continue;
            found.a[x.triangle] = found.b[y->triangle] = alike ? Match::Same : Match::Reversed;
            ++(alike ? found.both : found.reversed);
        }
    }
}

/// Goes through both lists, one set of three corners at a time.
MeshDifference pairAll(std::span<const Triangle> a, std::span<const Triangle> b) {
    MeshDifference found;
    found.a.assign(a.size(), Match::Missing);
    found.b.assign(b.size(), Match::Missing);
    const std::vector<Entry> left = sortedEntries(a);
    const std::vector<Entry> right = sortedEntries(b);
    auto i = left.begin();
    auto j = right.begin();
    while (i != left.end() && j != right.end()) {
        if (i->corners < j->corners) {
            ++i;
        } else if (j->corners < i->corners) {
            ++j;
        } else {
            const auto other = [&](const Entry& e) { return e.corners != i->corners; };
            const auto iEnd = std::find_if(i, left.end(), other);
            const auto jEnd = std::find_if(j, right.end(), other);
            pairTriangles({&*i, static_cast<std::size_t>(iEnd - i)},
                          {&*j, static_cast<std::size_t>(jEnd - j)}, found);
            i = iEnd;
            j = jEnd;
        }
    }
    found.onlyA = a.size() - found.both - found.reversed;
    found.onlyB = b.size() - found.both - found.reversed;
    return found;
}

/// Groups the triangles that are not in both by common points.
class RegionFinder {
  public:
    RegionFinder(std::span<const Vec3> position, std::span<const Triangle> a,
                 std::span<const Triangle> b, const MeshDifference& found)
        : position_(position), sets_(position.size()), regionOf_(position.size(), kNone) {
        join(a, found.a);
        join(b, found.b);
        place(a, found.a, &DifferenceRegion::inA);
        place(b, found.b, &DifferenceRegion::inB);
    }

    std::vector<DifferenceRegion> take() {
        for (DifferenceRegion& region : regions_) finish(region);
        const auto size = [](const DifferenceRegion& r) { return r.inA.size() + r.inB.size(); };
        std::sort(regions_.begin(), regions_.end(),
                  [&](const DifferenceRegion& x, const DifferenceRegion& y) {
                      return size(x) != size(y) ? size(x) > size(y)
                                                : x.points.front() < y.points.front();
                  });
        return std::move(regions_);
    }

  private:
    void join(std::span<const Triangle> triangles, const std::vector<Match>& match) {
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            if (match[i] == Match::Same) continue;
            sets_.unite(triangles[i].a, triangles[i].b);
            sets_.unite(triangles[i].b, triangles[i].c);
        }
    }
    void place(std::span<const Triangle> triangles, const std::vector<Match>& match,
               std::vector<Index> DifferenceRegion::*list) {
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            if (match[i] == Match::Same) continue;
            const Triangle& t = triangles[i];
            Index& number = regionOf_[sets_.find(t.a)];
            if (number == kNone) {
                number = static_cast<Index>(regions_.size());
                regions_.emplace_back();
            }
            DifferenceRegion& region = regions_[number];
            (region.*list).push_back(static_cast<Index>(i));
            region.points.insert(region.points.end(), {t.a, t.b, t.c});
        }
    }
    void finish(DifferenceRegion& region) const {
        sortUnique(region.points);
        Box box(position_[region.points.front()]);
        for (const Index p : region.points) box.add(position_[p]);
        region.place = (box.low + box.high) * 0.5;
        region.radius = glm::length(box.high - box.low) * 0.5;
    }

    std::span<const Vec3> position_;
    DisjointSets sets_;
    std::vector<Index> regionOf_;  ///< Per least point of a set: its region.
    std::vector<DifferenceRegion> regions_;
};

/// Points by position, to find one within a small distance.
class PointFinder {
  public:
    explicit PointFinder(std::span<const Vec3> points) : points_(points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (isFinite(points[i])) known_.push_back(static_cast<Index>(i));
        }
        if (known_.empty()) return;
        const WallBox box = boxAround(points);
        const double diagonal = glm::length(box.high - box.low);
        tolerance_ = kSamePointTolerance * diagonal;
        // Cells of about one point each; the tolerance is far smaller.
        const double cell = diagonal / std::max(2.0, std::sqrt(static_cast<double>(known_.size())));
        grid_.emplace(box.low, box.high, cell > 0.0 ? cell : 1.0);
        for (const Index p : known_) grid_->add(points[p]);
    }
    bool isAt(Index point, const Vec3& x) const {
        return point < points_.size() && glm::length(points_[point] - x) <= tolerance_;
    }
    /// kNone if no point is that near.
    Index at(const Vec3& x) const {
        Index best = kNone;
        if (!grid_ || !isFinite(x)) return best;
        double least = tolerance_;
        grid_->near(x, [&](Index number) {
            const Index p = known_[number];
            const double distance = glm::length(points_[p] - x);
            if (!(distance <= tolerance_)) return;
            if (best != kNone && (distance > least || (distance == least && p > best))) return;
            best = p;
            least = distance;
        });
        return best;
    }

  private:
    std::span<const Vec3> points_;
    std::vector<Index> known_;  ///< Points with a finite position, as the grid numbers them.
    std::optional<CellGrid> grid_;
    double tolerance_ = 0.0;
};

}  // namespace

MatchedMesh matchMesh(std::span<const Vec3> points, const PointFile& mesh) {
    assert(cornersBelow(mesh.faces, mesh.position.size()));
    const PointFinder finder(points);
    const bool sameCount = points.size() == mesh.position.size();
    const std::vector<bool> used = usedPoints(mesh.position.size(), mesh.faces);
    MatchedMesh matched;
    std::vector<Index> pointOf(mesh.position.size(), kNone);
    for (Index v = 0; v < mesh.position.size(); ++v) {
        if (!used[v]) continue;
        const Vec3& x = mesh.position[v];
        pointOf[v] = sameCount && finder.isAt(v, x) ? v : finder.at(x);
        if (pointOf[v] != kNone) continue;
        pointOf[v] = static_cast<Index>(points.size() + matched.unmatchedVertices.size());
        matched.unmatchedVertices.push_back(x);
        matched.unmatchedNumbers.push_back(v);
    }
    matched.triangles.reserve(mesh.faces.size());
    for (const Triangle& t : mesh.faces)
        matched.triangles.push_back({pointOf[t.a], pointOf[t.b], pointOf[t.c]});
    return matched;
}

MeshDifference compareMeshes(std::span<const Vec3> position, std::span<const Triangle> a,
                             std::span<const Triangle> b) {
    assert(cornersBelow(a, position.size()) && cornersBelow(b, position.size()));
    MeshDifference found = pairAll(a, b);
    found.regions = RegionFinder(position, a, b, found).take();
    return found;
}

TriangleSet::TriangleSet(std::span<const Triangle> mesh) : entries_(sortedEntries(mesh)) {}

Match TriangleSet::find(const Triangle& triangle) const {
    const Entry entry = entryOf(triangle, 0);
    const auto isThere = [&](bool odd) {
        const auto at =
            std::lower_bound(entries_.begin(), entries_.end(), Entry{entry.corners, odd, 0});
        return at != entries_.end() && at->corners == entry.corners && at->odd == odd;
    };
    if (isThere(entry.odd)) return Match::Same;
    return isThere(!entry.odd) ? Match::Reversed : Match::Missing;
}

std::vector<Triangle> freshTriangles(const std::vector<Triangle>& before,
                                     const std::vector<Triangle>& after) {
    const auto corners = [](const Triangle& t) {
        std::array<Index, 3> c = {t.a, t.b, t.c};
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        return c;
    };
    // The steps change a few entries of a long list, so only those are compared with each other.
    const std::size_t common = std::min(before.size(), after.size());
    std::set<std::array<Index, 3>> old;
    std::vector<Triangle> fresh;
    for (std::size_t i = 0; i < common; ++i) {
        if (before[i] == after[i]) continue;
        old.insert(corners(before[i]));
        fresh.push_back(after[i]);
    }
    for (std::size_t i = common; i < before.size(); ++i) old.insert(corners(before[i]));
    for (std::size_t i = common; i < after.size(); ++i) fresh.push_back(after[i]);
    std::erase_if(fresh, [&](const Triangle& t) { return old.contains(corners(t)); });
    return fresh;
}

}  // namespace se
