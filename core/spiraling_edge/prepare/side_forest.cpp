/// Orientation along a minimum spanning forest of the lists in both directions, where edges are
/// cheap whose mirrored normals agree. The forest is found by Boruvka's algorithm (1926): in each
/// round, every component is joined to another by the cheapest edge that leaves it, which points
/// look for in parallel. A union-find forest with parities holds the root of each point's component
/// and whether the two face the same side, so that edges need no storage. The order of edges is
/// strict, by weight and numbers: the forest is unique, whatever the threads do. O(list entries log
/// points), but a point searches its list again only if its component has grown over its cheapest
/// edge.
#include "spiraling_edge/prepare/side_forest.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "spiraling_edge/base/parallel.h"

namespace se {

namespace {

/// Least number of points per thread.
constexpr std::size_t kJoinedPerThread = 2048;

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

// ---- the forest ---------------------------------------------------------------------------------

class SideForest {
  public:
    SideForest(const SidesInput& input, double steepCost)
        : input_(input),
          steepCost_(steepCost),
          components_(input.normal.size()),
          exit_(input.normal.size(), kNone),
          weight_(input.normal.size()),
          cheapest_(input.normal.size()) {
        for (std::atomic<Index>& each : cheapest_) each.store(kNone, std::memory_order_relaxed);
        for (Index p = 0; p < input.normal.size(); ++p) {
            if (input.hasNormal(p)) searching_.push_back(p);
        }
        roots_ = searching_;
    }

    Result<PointSides> run(const Progress& progress) {
        double done = 0.0;
        while (!searching_.empty()) {
            // Each round at least halves the number of components that have exits.
            const double next = 0.5 * (done + 1.0);
            if (!findCheapest(partOf(progress, done, next)))
                return Error{"the work on normals was cancelled"};
            joinComponents();
            done = next;
        }
        return sides();
    }

  private:
    Index rootOf(Index p) const { return components_.toRoot(p).to; }
    Index numberOf(Index p) const { return input_.numbering.originalOf(p); }

    template <typename Work>
    void forEach(std::size_t count, Work&& work) const {
        forEachItem(count, input_.threads, kJoinedPerThread, work);
    }

    /// Finds the cheapest edge that leaves each component. False if cancelled.
    bool findCheapest(const Progress& progress) {
        const bool all = forEachWithProgress(
            searching_.size(), input_.threads, kJoinedPerThread, progress, [this](std::size_t i) {
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
        for (const auto list : {input_.lists[p], input_.listedBy[p]}) {
            for (const Index q : list) {
                if (rootOf(q) == root || !input_.hasNormal(q)) continue;
                const double weight = weightOf(p, q);
                // Of two edges of p, that to the lower number comes first in the order of edges.
                if (exit_[p] != kNone &&
                    (weight > weight_[p] ||
                     (weight == weight_[p] && numberOf(q) >= numberOf(exit_[p]))))
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
        while (other == kNone || isCheaper(p, other)) {
            if (cheapest.compare_exchange_weak(other, p, std::memory_order_acq_rel)) return;
        }
    }
    /// The order of edges from points to their exits: the same from both ends of an edge.
    bool isCheaper(Index p, Index other) const {
        if (weight_[p] != weight_[other]) return weight_[p] < weight_[other];
        return endsOf(p) < endsOf(other);
    }
    /// The numbers of p and its exit, the lower one first.
    std::pair<Index, Index> endsOf(Index p) const {
        return std::minmax({numberOf(p), numberOf(exit_[p])});
    }

    /// Joins the components along their cheapest edges.
    void joinComponents() {
        std::vector<SideLink> links(roots_.size());
        forEach(roots_.size(), [&](std::size_t i) { links[i] = linkOf(roots_[i]); });
        forEach(roots_.size(), [&](std::size_t i) {
            components_.connect(roots_[i], links[i]);
            cheapest_[roots_[i]].store(kNone, std::memory_order_relaxed);
        });
        forEach(input_.normal.size(),
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
        if (cheapest_[there.to] == q && exit_[q] == p && numberOf(root) < numberOf(there.to))
            return {root, 0};
        const unsigned turns = agreementOf(input_, p, q) < 0.0 ? 1U : 0U;
        return {there.to, here.opposed ^ there.opposed ^ turns};
    }

    double weightOf(Index p, Index q) const {
        const double flat = 1.0 - std::abs(agreementOf(input_, p, q));
        if (steepCost_ == 0.0) return flat;
        const Vec3 d = input_.position[q] - input_.position[p];
        const double lengthSq = glm::dot(d, d);
        if (!(lengthSq > 0.0)) return flat;
        const double atP = glm::dot(input_.normal[p], d);
        const double atQ = glm::dot(input_.normal[q], d);
        return flat + steepCost_ * (std::max(atP * atP, atQ * atQ) / lengthSq);
    }

    PointSides sides() const {
        PointSides sides;
        sides.component.assign(input_.normal.size(), kNone);
        sides.opposed.assign(input_.normal.size(), 0);
        std::vector<Index> number(input_.normal.size(), kNone);  // by root
        for (Index p = 0; p < input_.normal.size(); ++p) {
            if (!input_.hasNormal(p)) continue;
            const SideLink link = components_.toRoot(p);
            Index& own = number[link.to];
            if (own == kNone) own = static_cast<Index>(sides.components++);
            sides.component[p] = own;
            sides.opposed[p] = static_cast<std::uint8_t>(link.opposed);
        }
        return sides;
    }

    const SidesInput& input_;
    double steepCost_;
    SideComponents components_;
    std::vector<Index> exit_;     // the other end of a point's cheapest edge, or kNone
    std::vector<double> weight_;  // of that edge
    std::vector<std::atomic<Index>> cheapest_;  // by root: the point with the cheapest edge
    std::vector<Index> searching_;              // points that may have an exit
    std::vector<Index> roots_;                  // of components that may have one
};

}  // namespace

double agreementOf(const SidesInput& input, Index p, Index q) {
    const double plain = glm::dot(input.normal[p], input.normal[q]);
    const Vec3 d = input.position[q] - input.position[p];
    const double lengthSq = glm::dot(d, d);
    if (!(lengthSq > 0.0)) return plain;
    const double along = glm::dot(input.normal[p], d) * glm::dot(input.normal[q], d);
    const double mirrored = plain - 2.0 * (along / lengthSq);
    assert(!std::isnan(mirrored));
    return mirrored;
}

Result<PointSides> sidesAlongForest(const SidesInput& input, double steepCost,
                                    const Progress& progress) {
    return SideForest(input, steepCost).run(progress);
}

}  // namespace se
