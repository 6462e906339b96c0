/// Two meshes as sorted lists of corner triples, merged in one pass; triangles in only one of them
/// are joined by common points to regions (union-find). O(t log t).
#include "spiraling_edge/mesh/mesh_compare.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/geometry/box.h"

namespace se {
namespace {

/// The corners in ascending order; true if the triangle is wound against them.
bool sortCorners(std::array<Index, 3>& corners) {
    bool odd = false;
    for (const auto& [x, y] : {std::pair{0U, 1U}, {1U, 2U}, {0U, 1U}}) {
        if (corners[x] <= corners[y]) continue;
        std::swap(corners[x], corners[y]);
        odd = !odd;
    }
    return odd;
}

/// A triangle by its corners in ascending order.
struct Entry {
    std::array<Index, 3> corners;
    bool odd;  ///< Its winding, against that of the ascending corners.
    Index triangle;
};

std::vector<Entry> sortedEntries(std::span<const Triangle> triangles) {
    std::vector<Entry> entries;
    entries.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        Entry entry{{t.a, t.b, t.c}, false, static_cast<Index>(i)};
        entry.odd = sortCorners(entry.corners);
        entries.push_back(entry);
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
        return std::tie(x.corners, x.odd, x.triangle) < std::tie(y.corners, y.odd, y.triangle);
    });
    return entries;
}

/// Goes through both lists, one set of three corners at a time.
class Pairing {
  public:
    Pairing(std::span<const Triangle> a, std::span<const Triangle> b) {
        found_.a.assign(a.size(), Match::Missing);
        found_.b.assign(b.size(), Match::Missing);
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
                pair({&*i, static_cast<std::size_t>(iEnd - i)},
                     {&*j, static_cast<std::size_t>(jEnd - j)});
                i = iEnd;
                j = jEnd;
            }
        }
        found_.onlyA = a.size() - found_.both - found_.reversed;
        found_.onlyB = b.size() - found_.both - found_.reversed;
    }
    MeshDifference take() { return std::move(found_); }

  private:
    /// Pairs triangles of equal winding first, then the rest.
    void pair(std::span<const Entry> a, std::span<const Entry> b) {
        for (const bool alike : {true, false}) {
            for (const Entry& x : a) {
                if (found_.a[x.triangle] != Match::Missing) continue;
                const auto y = std::find_if(b.begin(), b.end(), [&](const Entry& e) {
                    return found_.b[e.triangle] == Match::Missing && (e.odd == x.odd) == alike;
                });
                if (y == b.end()) continue;
                found_.a[x.triangle] = found_.b[y->triangle] =
                    alike ? Match::Same : Match::Reversed;
                ++(alike ? found_.both : found_.reversed);
            }
        }
    }

    MeshDifference found_;
};

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
        std::sort(region.points.begin(), region.points.end());
        region.points.erase(std::unique(region.points.begin(), region.points.end()),
                            region.points.end());
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

}  // namespace

MeshDifference compareMeshes(std::span<const Vec3> position, std::span<const Triangle> a,
                             std::span<const Triangle> b) {
    assert(cornersBelow(a, position.size()) && cornersBelow(b, position.size()));
    MeshDifference found = Pairing(a, b).take();
    found.regions = RegionFinder(position, a, b, found).take();
    return found;
}

TriangleSet::Entry TriangleSet::entryOf(const Triangle& t) {
    Entry entry{{t.a, t.b, t.c}, false};
    entry.odd = sortCorners(entry.corners);
    return entry;
}

TriangleSet::TriangleSet(std::span<const Triangle> mesh) {
    entries_.reserve(mesh.size());
    for (const Triangle& t : mesh) entries_.push_back(entryOf(t));
    std::sort(entries_.begin(), entries_.end());
}

Match TriangleSet::find(const Triangle& triangle) const {
    Entry entry = entryOf(triangle);
    if (std::binary_search(entries_.begin(), entries_.end(), entry)) return Match::Same;
    entry.odd = !entry.odd;
    return std::binary_search(entries_.begin(), entries_.end(), entry) ? Match::Reversed
                                                                       : Match::Missing;
}

}  // namespace se
