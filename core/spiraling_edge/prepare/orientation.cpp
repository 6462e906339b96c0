/// Orientation along a minimum spanning forest of the lists in both directions, where edges are
/// cheap whose mirrored normals agree. The forest is found by Boruvka's algorithm (1926): in each
/// round, every component is joined to another by the cheapest edge that leaves it, which points
/// look for in parallel. A union-find forest with parities holds the root of each point's component
/// and whether the two face the same side, so that edges need no storage. The order of edges is
/// strict, by weight and indices: the forest is unique, whatever the threads do. O(list entries log
/// points), but a point searches its list again only if its component has grown over its cheapest
/// edge.
#include "spiraling_edge/prepare/orientation.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

namespace {

/// Least number of points per thread.
constexpr std::size_t kOrientedPerThread = 2048;

// ---- components ---------------------------------------------------------------------------------

/// A point of the same component, and whether the two normals face different sides (1) or not (0).
struct SideLink {
    Index to = kNone;
    std::uint32_t opposed = 0;
};

/// Components of points, and the sides that their normals face: union-find with parities. Threads
/// may call all functions but connect() at the same time: each link that one of them replaces is
/// true before and after.
class SideComponents {
  public:
    explicit SideComponents(std::size_t count) : link_(count) {
        for (Index p = 0; p < count; ++p) store(p, {p, 0});
    }

    /// Link of p to the root of its component. Requires flatten() of all points since connect().
    SideLink toRoot(Index p) const { return load(p); }
    bool isRoot(Index p) const { return load(p).to == p; }
    /// Connects a root to another component, or to itself. Threads may connect different roots.
    void connect(Index root, const SideLink& link) { store(root, link); }

    /// Links p to its root, and points between the two closer to it (path halving).
    void flatten(Index p) {
        Index at = p;
        SideLink link = load(p);
        SideLink whole{p, 0};
        while (true) {
            const SideLink above = load(link.to);
            if (above.to == link.to) break;
            const SideLink farther{above.to, link.opposed ^ above.opposed};
            store(at, farther);
            whole.opposed ^= farther.opposed;
            at = farther.to;
            link = load(at);
        }
        store(p, {link.to, whole.opposed ^ link.opposed});
    }

  private:
    SideLink load(Index p) const { return link_[p].load(std::memory_order_relaxed); }
    void store(Index p, const SideLink& link) { link_[p].store(link, std::memory_order_relaxed); }

    std::vector<std::atomic<SideLink>> link_;
};

// ---- the first point of a component -------------------------------------------------------------

/// The points of a component that lie farthest out, along the axes and against them.
class Outermost {
  public:
    explicit Outermost(Index p) { point_.fill(p); }

    /// Takes the points in ascending order.
    void add(std::span<const Vec3> position, Index p) {
        for (std::size_t i = 0; i < point_.size(); ++i) {
            if (ahead(position, i, p) > 0.0) point_[i] = p;
        }
    }

    /// The point that is outermost along the axis that its normal follows best, and 1 if its normal
    /// points inward.
    SideLink first(std::span<const Vec3> normal) const {
        SideLink best;
        double bestShare = -1.0;
        for (std::size_t i = 0; i < point_.size(); ++i) {
            const double along = normal[point_[i]][axisOf(i)];
            if (std::abs(along) <= bestShare) continue;
            bestShare = std::abs(along);
            best = {point_[i], signOf(i) * along < 0.0 ? 1U : 0U};
        }
        return best;
    }

  private:
    static int axisOf(std::size_t i) { return static_cast<int>(i / 2); }
    static double signOf(std::size_t i) { return i % 2 == 0 ? 1.0 : -1.0; }
    double ahead(std::span<const Vec3> position, std::size_t i, Index p) const {
        return signOf(i) * (position[p][axisOf(i)] - position[point_[i]][axisOf(i)]);
    }

    std::array<Index, 6> point_;
};

// ---- the forest ---------------------------------------------------------------------------------

class Orientation {
  public:
    Orientation(std::span<const Vec3> position, const NeighborLists& neighbors,
                std::vector<Vec3>& normal, unsigned threads)
        : position_(position),
          normal_(normal),
          threads_(threads),
          lists_(neighbors),
          listedBy_(listersOf(neighbors)),
          components_(normal.size()),
          exit_(normal.size(), kNone),
          weight_(normal.size()),
          cheapest_(normal.size()) {
        for (std::atomic<Index>& each : cheapest_) each.store(kNone, std::memory_order_relaxed);
        for (Index p = 0; p < normal_.size(); ++p) {
            if (hasNormal(p)) searching_.push_back(p);
        }
        roots_ = searching_;
    }

    Result<OrientationReport> run(const Progress& progress) {
        double done = 0.0;
        while (!searching_.empty()) {
            // Each round at least halves the number of components that have exits.
            const double next = 0.5 * (done + 1.0);
            if (!findCheapest(partOf(progress, done, next)))
                return Error{"the work on normals was cancelled"};
            joinComponents();
            done = next;
        }
        report_.doubtful = doubtful_;
        turnOutward();
        return report_;
    }

  private:
    bool hasNormal(Index p) const { return normal_[p] != Vec3(0.0); }
    Index rootOf(Index p) const { return components_.toRoot(p).to; }

    template <typename Work>
    void forEach(std::size_t count, Work&& work) const {
        forEachItem(count, threads_, kOrientedPerThread, work);
    }

    /// Finds the cheapest edge that leaves each component. False if cancelled.
    bool findCheapest(const Progress& progress) {
        const bool all = forEachWithProgress(
            searching_.size(), threads_, kOrientedPerThread, progress, [this](std::size_t i) {
                const Index p = searching_[i];
                // While it leaves the component, the cheapest exit remains the cheapest.
                if (exit_[p] == kNone || rootOf(exit_[p]) == rootOf(p)) findExit(p);
                if (exit_[p] != kNone) offer(p);
            });
        std::erase_if(searching_, [this](Index p) { return exit_[p] == kNone; });
        std::erase_if(roots_, [this](Index root) { return cheapest_[root] == kNone; });
        return all;
    }

    /// Finds the cheapest edge from p to another component.
    void findExit(Index p) {
        const Index root = rootOf(p);
        exit_[p] = kNone;
        for (const auto list : {lists_[p], listedBy_[p]}) {
            for (const Index q : list) {
                if (rootOf(q) == root || !hasNormal(q)) continue;
                const double weight = 1.0 - std::abs(agreement(p, q));
                // Of two edges of p, that to the lower index comes first in the order of edges.
                if (exit_[p] != kNone &&
                    (weight > weight_[p] || (weight == weight_[p] && q >= exit_[p])))
                    continue;
                exit_[p] = q;
                weight_[p] = weight;
            }
        }
    }

    /// Takes the edge of p for that of its component if it is cheaper than those so far. Which of
    /// several threads comes first makes no difference, as the order of edges is strict.
    void offer(Index p) {
        std::atomic<Index>& cheapest = cheapest_[rootOf(p)];
        Index other = cheapest.load(std::memory_order_acquire);
        while (other == kNone || edgeOf(p) < edgeOf(other)) {
            if (cheapest.compare_exchange_weak(other, p, std::memory_order_acq_rel)) return;
        }
    }
    /// The edge from p to its exit, as ordered: the same from both of its ends.
    std::tuple<double, Index, Index> edgeOf(Index p) const {
        return {weight_[p], std::min(p, exit_[p]), std::max(p, exit_[p])};
    }

    /// Joins the components along their cheapest edges.
    void joinComponents() {
        std::vector<SideLink> links(roots_.size());
        forEach(roots_.size(), [&](std::size_t i) { links[i] = linkOf(roots_[i]); });
        forEach(roots_.size(), [&](std::size_t i) {
            components_.connect(roots_[i], links[i]);
            cheapest_[roots_[i]].store(kNone, std::memory_order_relaxed);
        });
        forEach(normal_.size(),
                [this](std::size_t p) { components_.flatten(static_cast<Index>(p)); });
        std::erase_if(roots_, [this](Index root) { return !components_.isRoot(root); });
    }

    /// The link from a root along the cheapest edge of its component. Where two components have the
    /// same edge, the lower root remains one: there are no other circles.
    SideLink linkOf(Index root) {
        const Index p = cheapest_[root];
        const Index q = exit_[p];
        const SideLink here = components_.toRoot(p);
        const SideLink there = components_.toRoot(q);
        if (cheapest_[there.to] == q && exit_[q] == p && root < there.to) return {root, 0};
        const double cosine = agreement(p, q);
        constexpr double kDoubtful = 0.1;
        if (std::abs(cosine) < kDoubtful) ++doubtful_;
        return {there.to, here.opposed ^ there.opposed ^ (cosine < 0.0 ? 1U : 0U)};
    }

    /// Cosine between the normal of q and that of p mirrored at the plane halfway between them: 1
    /// if a circle runs through both, also across a thin part. The same for (q, p), bit for bit.
    double agreement(Index p, Index q) const {
        const double plain = glm::dot(normal_[p], normal_[q]);
        const Vec3 d = position_[q] - position_[p];
        const double lengthSq = glm::dot(d, d);
        if (!(lengthSq > 0.0)) return plain;
        const double along = glm::dot(normal_[p], d) * glm::dot(normal_[q], d);
        const double mirrored = plain - 2.0 * (along / lengthSq);
        assert(!std::isnan(mirrored));
        return mirrored;
    }

    /// Turns the normals of each component so that that of its first point faces outward.
    void turnOutward() {
        std::vector<Index> part(normal_.size(), kNone);  // by root
        std::vector<Outermost> outermost;
        for (Index p = 0; p < normal_.size(); ++p) {
            if (!hasNormal(p)) continue;
            Index& own = part[rootOf(p)];
            if (own == kNone) {
                own = static_cast<Index>(outermost.size());
                outermost.emplace_back(p);
            }
            outermost[own].add(position_, p);
        }
        std::vector<std::uint32_t> inward;  // 1 where the root's normal points inward
        for (const Outermost& each : outermost) {
            const SideLink first = each.first(normal_);
            inward.push_back(first.opposed ^ components_.toRoot(first.to).opposed);
        }
        std::atomic<std::size_t> turned = 0;
        forRanges(normal_.size(), threads_, kOrientedPerThread,
                  [&](std::size_t from, std::size_t to) {
                      std::size_t count = 0;
                      for (auto p = static_cast<Index>(from); p < to; ++p) {
                          const SideLink link = components_.toRoot(p);
                          if (!hasNormal(p) || link.opposed == inward[part[link.to]]) continue;
                          normal_[p] = -normal_[p];
                          ++count;
                      }
                      turned += count;
                  });
        report_.components = outermost.size();
        report_.turned = turned;
    }

    std::span<const Vec3> position_;
    std::vector<Vec3>& normal_;
    unsigned threads_;
    const NeighborLists& lists_;
    NeighborLists listedBy_;
    SideComponents components_;
    std::vector<Index> exit_;     // the other end of a point's cheapest edge, or kNone
    std::vector<double> weight_;  // of that edge
    std::vector<std::atomic<Index>> cheapest_;  // by root: the point with the cheapest edge
    std::vector<Index> searching_;              // points that may have an exit
    std::vector<Index> roots_;                  // of components that may have one
    std::atomic<std::size_t> doubtful_ = 0;
    OrientationReport report_;
};

}  // namespace

Result<OrientationReport> orientNormals(std::span<const Vec3> position,
                                        const NeighborLists& neighbors, std::vector<Vec3>& normal,
                                        unsigned threads, const Progress& progress) {
    return Orientation(position, neighbors, normal, threads).run(progress);
}

}  // namespace se
