/// Points of faults are joined by a grid whose cells are so small that all points of one are within
/// reach; of two cells only as many pairs are tried as it takes to join them.
#include "spiraling_edge/mesh/fault_places.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <tuple>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/geometry/box.h"

namespace se {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// A point of a fault; one for each fault that has it.
struct FaultPoint {
    Index point;
    Index fault;  ///< Position in the list of faults.
};

/// Joins faults with points nearer than `reach`.
class NearFaults {
  public:
    NearFaults(const PointSet& points, double reach, std::size_t faults)
        : points_(points), reach_(reach), joined_(faults) {}

    void add(const FaultPoint& each) { cells_[cellOf(each.point)].push_back(each); }

    /// The sets of joined faults, each named by its least fault.
    DisjointSets& join() {
        for (const auto& [cell, here] : cells_) {
            // All within reach of one another.
            for (const FaultPoint& each : here) joined_.unite(here.front().fault, each.fault);
            joinAround(cell, here);
        }
        return joined_;
    }

  private:
    /// The diagonal of a cell is the reach: points farther apart than this many cells are not near.
    static constexpr std::int64_t kCells = 2;

    /// Joins a cell with the later ones around it.
    void joinAround(const Cell& cell, const std::vector<FaultPoint>& here) {
        for (std::int64_t x = cell[0]; x <= cell[0] + kCells; ++x) {
            for (std::int64_t y = cell[1] - kCells; y <= cell[1] + kCells; ++y) {
                const Cell first = std::max(cell, Cell{x, y, cell[2] - kCells});
                const Cell last{x, y, cell[2] + kCells};
                for (auto other = cells_.lower_bound(first);
                     other != cells_.end() && other->first <= last; ++other)
                    joinCells(here, other->second);
            }
        }
    }
    Cell cellOf(Index p) const {
        constexpr double kMost = 1e15;
        Cell cell{};
        for (int i = 0; i < 3; ++i) {
            const double at = reach_ > 0.0 ? points_.position[p][i] * std::sqrt(3.0) / reach_ : 0.0;
            cell[static_cast<std::size_t>(i)] =
                static_cast<std::int64_t>(std::floor(std::clamp(at, -kMost, kMost)));
        }
        return cell;
    }
    void joinCells(const std::vector<FaultPoint>& a, const std::vector<FaultPoint>& b) {
        if (joined_.find(a.front().fault) == joined_.find(b.front().fault)) return;
        for (const FaultPoint& one : a) {
            for (const FaultPoint& other : b) {
                const Vec3 d = points_.position[one.point] - points_.position[other.point];
                if (glm::dot(d, d) < reach_ * reach_) {
                    joined_.unite(one.fault, other.fault);
                    return;
                }
            }
        }
    }

    const PointSet& points_;
    double reach_;
    DisjointSets joined_;
    std::map<Cell, std::vector<FaultPoint>> cells_;
};

/// True if `a` is more severe.
bool isMoreSevere(const MeshFailure& a, const MeshFailure& b) {
    return std::tuple(a.kind->severity, -a.length) < std::tuple(b.kind->severity, -b.length);
}

void enclose(const PointSet& points, std::span<const MeshFailure> failures, FaultPlace& place) {
    Box box(points.position[failures[place.faults.front()].points.front()]);
    for (const std::size_t i : place.faults) {
        for (const Index p : failures[i].points) box.add(points.position[p]);
    }
    place.center = 0.5 * (box.low + box.high);
    for (const std::size_t i : place.faults) {
        for (const Index p : failures[i].points)
            place.radius = std::max(place.radius, glm::distance(place.center, points.position[p]));
    }
}

}  // namespace

std::vector<FaultPlace> faultPlaces(const PointSet& points, std::span<const MeshFailure> failures,
                                    double meanEdge) {
    std::vector<std::size_t> faults;
    for (std::size_t i = 0; i < failures.size(); ++i) {
        assert(!failures[i].points.empty());
        if (failures[i].kind->fault) faults.push_back(i);
    }
    NearFaults near(points, kPlaceReach * meanEdge, faults.size());
    for (Index i = 0; i < faults.size(); ++i) {
        for (const Index p : failures[faults[i]].points) near.add({p, i});
    }
    DisjointSets& joined = near.join();
    std::map<Index, FaultPlace> byLeast;
    for (Index i = 0; i < faults.size(); ++i) byLeast[joined.find(i)].faults.push_back(faults[i]);
    std::vector<FaultPlace> places;
    for (auto& [least, place] : byLeast) {
        std::stable_sort(
            place.faults.begin(), place.faults.end(),
            [&](std::size_t a, std::size_t b) { return isMoreSevere(failures[a], failures[b]); });
        enclose(points, failures, place);
        places.push_back(std::move(place));
    }
    std::sort(places.begin(), places.end(), [&](const FaultPlace& a, const FaultPlace& b) {
        const MeshFailure& worst = failures[a.faults.front()];
        const MeshFailure& other = failures[b.faults.front()];
        if (isMoreSevere(worst, other)) return true;
        if (isMoreSevere(other, worst)) return false;
        if (a.faults.size() != b.faults.size()) return a.faults.size() > b.faults.size();
        return a.faults.front() < b.faults.front();
    });
    return places;
}

std::string describe(const FaultPlace& place, std::span<const MeshFailure> failures) {
    std::string text;
    for (std::size_t begin = 0; begin < place.faults.size();) {
        const FailureClass& kind = *failures[place.faults[begin]].kind;
        std::size_t end = begin;
        while (end < place.faults.size() && failures[place.faults[end]].kind == &kind) ++end;
        if (!text.empty()) text += ", ";
        text += std::to_string(end - begin) + " " + nounFor(kind, end - begin);
        // The largest is first.
        const std::size_t edges = failures[place.faults[begin]].triangles.size();
        if (failures[place.faults[begin]].length > 0.0)
            text += (end - begin == 1 ? " of " : " of up to ") + std::to_string(edges) + " edges";
        begin = end;
    }
    return text;
}

}  // namespace se
