/// Faults are taken in the order of severity; a grid of their points finds those near one. A point
/// that was found is not visited again, since all of its faults are at a place then.
#include "spiraling_edge/mesh/fault_places.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <tuple>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/points/wall_types.h"

namespace se {
namespace {

/// Classes that are named in the description of a place.
constexpr std::size_t kNamedClasses = 3;

/// The points of faults, each once, with its faults.
class FaultPoints {
  public:
    /// `faults`: positions in the list of failures.
    FaultPoints(const PointSet& points, std::span<const MeshFailure> failures,
                std::span<const std::size_t> faults, double reach)
        : points_(points), reach_(reach) {
        for (const std::size_t fault : faults) {
            for (const Index p : failures[fault].points) pairs_.emplace_back(p, fault);
        }
        std::sort(pairs_.begin(), pairs_.end());
        std::vector<Vec3> position;
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            if (i > 0 && pairs_[i].first == pairs_[i - 1].first) continue;
            begin_.push_back(i);
            position.push_back(points.position[pairs_[i].first]);
        }
        left_.assign(begin_.size(), true);
        if (position.empty() || !(reach > 0.0)) return;
        const WallBox box = boxAround(position);
        grid_.emplace(box.low, box.high, reach);
        for (const Vec3& x : position) grid_->add(x);
    }

    /// Calls `visit` with the faults at each point within reach of `p`, and at `p` itself, but for
    /// points that were passed to it before.
    template <typename Visit>
    void takeNear(Index p, Visit&& visit) {
        const Vec3& x = points_.position[p];
        const auto take = [&](Index i) {
            if (!left_[i]) return;
            const Vec3 d = points_.position[pairs_[begin_[i]].first] - x;
            if (pairs_[begin_[i]].first != p && !(glm::dot(d, d) < reach_ * reach_)) return;
            left_[i] = false;
            const std::size_t end = i + 1 < begin_.size() ? begin_[i + 1] : pairs_.size();
            for (std::size_t k = begin_[i]; k < end; ++k) visit(pairs_[k].second);
        };
        if (grid_) return grid_->near(x, take);
        const auto at = std::partition_point(begin_.begin(), begin_.end(), [&](std::size_t first) {
            return pairs_[first].first < p;
        });
        take(static_cast<Index>(at - begin_.begin()));
    }

  private:
    const PointSet& points_;
    double reach_;
    std::vector<std::pair<Index, std::size_t>> pairs_;  ///< Points and faults, in order.
    std::vector<std::size_t> begin_;                    ///< Per point: its first pair.
    std::vector<bool> left_;                            ///< Per point: not passed on yet.
    std::optional<CellGrid> grid_;
};

/// True if `a` is more severe.
bool isMoreSevere(const MeshFailure& a, const MeshFailure& b) {
    return std::tuple(a.kind->severity, -a.length) < std::tuple(b.kind->severity, -b.length);
}

}  // namespace

std::vector<FaultPlace> faultPlaces(const PointSet& points, std::span<const MeshFailure> failures,
                                    double meanEdge) {
    std::vector<std::size_t> bySeverity;
    for (std::size_t i = 0; i < failures.size(); ++i) {
        assert(!failures[i].points.empty());
        if (failures[i].kind->fault) bySeverity.push_back(i);
    }
    const auto inOrder = [&](std::size_t a, std::size_t b) {
        return isMoreSevere(failures[a], failures[b]);
    };
    std::stable_sort(bySeverity.begin(), bySeverity.end(), inOrder);
    FaultPoints around(points, failures, bySeverity, kPlaceReach * meanEdge);
    std::vector<bool> placed(failures.size(), false);
    std::vector<FaultPlace> places;
    for (const std::size_t worst : bySeverity) {
        if (placed[worst]) continue;
        FaultPlace place;
        for (const Index p : failures[worst].points) {
            around.takeNear(p, [&](std::size_t fault) {
                if (!placed[fault]) place.faults.push_back(fault);
                placed[fault] = true;
            });
        }
        std::sort(place.faults.begin(), place.faults.end());
        std::stable_sort(place.faults.begin(), place.faults.end(), inOrder);
        place.center = failures[worst].place;
        for (const Index p : failures[worst].points)
            place.radius = std::max(place.radius, glm::distance(place.center, points.position[p]));
        places.push_back(std::move(place));
    }
    return places;
}

std::string describe(const FaultPlace& place, std::span<const MeshFailure> failures) {
    std::string text;
    std::size_t begin = 0;
    for (std::size_t named = 0; begin < place.faults.size() && named < kNamedClasses; ++named) {
        const MeshFailure& first = failures[place.faults[begin]];
        std::size_t end = begin;
        while (end < place.faults.size() && failures[place.faults[end]].kind == first.kind) ++end;
        const std::size_t count = end - begin;
        text +=
            (text.empty() ? "" : ", ") + std::to_string(count) + " " + nounFor(*first.kind, count);
        // The longest loop is first.
        if (!first.edges.empty())
            text += (count == 1 ? " of " : " of up to ") + counted(first.edges.size(), "edge");
        begin = end;
    }
    const std::size_t others = place.faults.size() - begin;
    if (others > 0) text += ", " + counted(others, "other");
    return text;
}

}  // namespace se
