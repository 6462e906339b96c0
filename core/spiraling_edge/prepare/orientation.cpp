/// Orientation by Prim's algorithm over the lists in both directions, cheapest where mirrored
/// normals agree best. O(entries log entries).
#include "spiraling_edge/prepare/orientation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <queue>

#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

namespace {

Error cancelled() { return Error{"the work on normals was cancelled"}; }

/// Counts items and reports to `progress` once in some thousand.
class Ticks {
  public:
    Ticks(std::size_t count, const Progress& progress) : count_(count), progress_(progress) {}
    /// One more item begins; false if cancelled.
    bool next() {
        constexpr std::size_t kEvery = 4096;
        const std::size_t done = done_++;
        if (!progress_ || done % kEvery != 0) return true;
        return progress_(static_cast<double>(done) / static_cast<double>(count_));
    }

  private:
    std::size_t count_;
    std::size_t done_ = 0;
    const Progress& progress_;
};

/// A step of the tree, cheapest first; ties by index.
struct TreeStep {
    double weight;
    Index from, to;
    friend bool operator>(const TreeStep& a, const TreeStep& b) {
        if (a.weight != b.weight) return a.weight > b.weight;
        return a.from != b.from ? a.from > b.from : a.to > b.to;
    }
};

class Orientation {
  public:
    Orientation(std::span<const Vec3> position, const NeighborLists& neighbors,
                std::vector<Vec3>& normal, const Progress& progress)
        : position_(position),
          normal_(normal),
          lists_(neighbors),
          listedBy_(listersOf(neighbors)),
          reached_(normal.size(), false),
          ticks_(normal.size(), progress) {}

    Result<OrientationReport> run() {
        std::vector<bool> seen(normal_.size(), false);
        for (Index p = 0; p < normal_.size(); ++p) {
            if (seen[p] || normal_[p] == Vec3(0.0)) continue;
            ++report_.components;
            if (!grow(firstOf(collect(p, seen)))) return cancelled();
        }
        return report_;
    }

  private:
    /// Calls visit(q) for the points that p lists and for those that list it, if they have a
    /// normal.
    template <typename Visit>
    void forEachNeighbor(Index p, Visit&& visit) const {
        for (const auto list : {lists_[p], listedBy_[p]}) {
            for (const Index q : list) {
                if (normal_[q] != Vec3(0.0)) visit(q);
            }
        }
    }

    /// Collects the component of p.
    std::vector<Index> collect(Index p, std::vector<bool>& seen) const {
        std::vector<Index> component{p};
        seen[p] = true;
        for (std::size_t i = 0; i < component.size(); ++i) {
            forEachNeighbor(component[i], [&](Index q) {
                if (seen[q]) return;
                seen[q] = true;
                component.push_back(q);
            });
        }
        return component;
    }

    /// The first point of a component, its normal turned outward.
    Index firstOf(const std::vector<Index>& component) {
        Index best = component.front();
        double bestShare = -1.0;
        Vec3 out(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            for (const double sign : {1.0, -1.0}) {
                Index extreme = component.front();
                for (const Index p : component) {
                    const double ahead = sign * (position_[p][axis] - position_[extreme][axis]);
                    if (ahead > 0.0 || (ahead == 0.0 && p < extreme)) extreme = p;
                }
                const double share = std::abs(normal_[extreme][axis]);
                if (share <= bestShare) continue;
                bestShare = share;
                best = extreme;
                out = Vec3(0.0);
                out[axis] = sign;
            }
        }
        if (glm::dot(normal_[best], out) < 0.0) turn(best);
        return best;
    }

    /// Prim's algorithm. False if cancelled.
    bool grow(Index first) {
        std::priority_queue<TreeStep, std::vector<TreeStep>, std::greater<>> steps;
        const auto reach = [&](Index p) {
            reached_[p] = true;
            forEachNeighbor(p, [&](Index q) {
                if (!reached_[q]) steps.push({1.0 - std::abs(agreement(p, q)), p, q});
            });
        };
        reach(first);
        while (!steps.empty()) {
            const TreeStep step = steps.top();
            steps.pop();
            if (reached_[step.to]) continue;
            if (!ticks_.next()) return false;
            const double cosine = agreement(step.from, step.to);
            constexpr double kDoubtful = 0.1;
            if (std::abs(cosine) < kDoubtful) ++report_.doubtful;
            if (cosine < 0.0) turn(step.to);
            reach(step.to);
        }
        return true;
    }

    /// Cosine between the normal of q and that of p mirrored at the plane halfway between them: 1
    /// if a circle runs through both, also across a thin part.
    double agreement(Index p, Index q) const {
        const Vec3 d = position_[q] - position_[p];
        const double lengthSq = glm::dot(d, d);
        if (!(lengthSq > 0.0)) return glm::dot(normal_[p], normal_[q]);
        const Vec3 mirrored = normal_[p] - (2.0 * glm::dot(normal_[p], d) / lengthSq) * d;
        return glm::dot(mirrored, normal_[q]);
    }

    void turn(Index p) {
        normal_[p] = -normal_[p];
        ++report_.turned;
    }

    std::span<const Vec3> position_;
    std::vector<Vec3>& normal_;
    const NeighborLists& lists_;
    NeighborLists listedBy_;
    std::vector<bool> reached_;
    Ticks ticks_;
    OrientationReport report_;
};

}  // namespace

Result<OrientationReport> orientNormals(std::span<const Vec3> position,
                                        const NeighborLists& neighbors, std::vector<Vec3>& normal,
                                        const Progress& progress) {
    return Orientation(position, neighbors, normal, progress).run();
}

}  // namespace se
