/// Rims without a mesh: angular gaps between neighbors in the tangent plane give candidates, and
/// walks from gap to gap join them to closed chains. Angles are keys without trigonometry. Each
/// list entry is walked at most once, so that the walks cost O(list entries times longest list).
#include "spiraling_edge/prepare/rim.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/loop_shape.h"

namespace se {
namespace {

// ---- directions in a tangent plane --------------------------------------------------------------

// Angles are keys, as those of Angle: 1 - cos up to 180 degrees, 3 + cos beyond; 0 to 4.
constexpr double kKey60 = 0.5;
constexpr double kKey120 = 1.5;
constexpr double kKey150 = 1.8660254037844386;
constexpr double kFullTurnOfKeys = 4.0;

using FlatPoint = glm::dvec2;

/// Angle key from u counterclockwise to v, both of unit length; 0 for the same direction up to
/// rounding.
double keyFrom(const FlatPoint& u, const FlatPoint& v) {
    constexpr double kSameDirection = 1e-9;
    const double cosine = std::clamp(u.x * v.x + u.y * v.y, -1.0, 1.0);
    const double sine = u.x * v.y - u.y * v.x;
    if (cosine > 0.0 && std::abs(sine) < kSameDirection) return 0.0;
    return sine < 0.0 ? 3.0 + cosine : 1.0 - cosine;
}

/// A neighbor, by its direction.
struct Spoke {
    double key;
    Index point;
    FlatPoint direction;
    double lengthSq;
    friend bool operator<(const Spoke& a, const Spoke& b) {
        return a.key < b.key || (a.key == b.key && a.point < b.point);
    }
};

/// A sector without neighbors.
struct Gap {
    RimGap ends;
    double key = 0.0;  ///< Width, as a key.
};

/// The neighbors of one point in projection along its normal, counterclockwise.
class Spokes {
  public:
    /// Keys count from the direction of `reference`, unless turned back (below).
    Spokes(std::span<const Vec3> position, const Vec3& normal, Index p, Index reference,
           std::span<const Index> list) {
        const Vec3 z = position[reference] - position[p];
        x_ = z - glm::dot(z, normal) * normal;
        const double length = std::sqrt(glm::dot(x_, x_));
        if (!(length > 0.0)) return;
        x_ /= length;
        y_ = glm::cross(normal, x_);
        spokes_.reserve(list.size());
        for (const Index q : list) add(q, position[q] - position[p]);
        sortFrom({1.0, 0.0});
    }
    /// Moves key 0 to 60 degrees before the reference.
    void turnBack() { sortFrom({0.5, -0.86602540378443865}); }

    /// The widest gap that begins at a key up to `last` and does not end at `except`; the first of
    /// those that are equally wide.
    Gap widest(double last, Index except) const {
        const Spoke* from = nullptr;
        const Spoke* to = nullptr;
        double widestKey = 0.0;
        for (std::size_t i = 0; i < spokes_.size() && spokes_[i].key <= last; ++i) {
            const Spoke& next = spokes_[i + 1 < spokes_.size() ? i + 1 : 0];
            if (next.point == except || next.point == spokes_[i].point) continue;
            const double key = keyFrom(spokes_[i].direction, next.direction);
            if (!(key > widestKey)) continue;
            widestKey = key;
            from = &spokes_[i];
            to = &next;
        }
        if (from == nullptr) return {};
        return {{nearestAlong(*from), nearestAlong(*to)}, widestKey};
    }

  private:
    void add(Index q, const Vec3& offset) {
        const FlatPoint along{glm::dot(x_, offset), glm::dot(y_, offset)};
        const double length = std::sqrt(along.x * along.x + along.y * along.y);
        if (!(length > 0.0)) return;  // Above or below the point.
        spokes_.push_back({0.0, q, {along.x / length, along.y / length}, length * length});
    }
    /// On a lattice several neighbors lie in one direction, up to the tilt of the normal: the
    /// nearest of them.
    Index nearestAlong(const Spoke& spoke) const {
        constexpr double kAlong = 0.999994;  // 0.2 degrees
        const Spoke* best = &spoke;
        for (const Spoke& other : spokes_) {
            const double cosine =
                spoke.direction.x * other.direction.x + spoke.direction.y * other.direction.y;
            if (other.lengthSq < best->lengthSq && cosine > kAlong) best = &other;
        }
        return best->point;
    }
    void sortFrom(const FlatPoint& reference) {
        for (Spoke& spoke : spokes_) spoke.key = keyFrom(reference, spoke.direction);
        std::sort(spokes_.begin(), spokes_.end());
    }

    Vec3 x_{0.0}, y_{0.0};
    std::vector<Spoke> spokes_;
};

// ---- the search ---------------------------------------------------------------------------------

/// Number of neighbors used: longer lists reach beyond the points around a point, and over narrow
/// openings.
constexpr std::size_t kNearestOfRim = 12;
/// Of three points of a chain, this many must be candidates.
constexpr std::size_t kOfThree = 2;

/// True if neighbors lie in all six sectors of 60 degrees about p: a gap of 120 degrees would leave
/// one of them empty. The sectors begin at 17 degrees, where lattices have no neighbors.
bool isSurrounded(std::span<const Vec3> position, const Vec3& normal, Index p,
                  std::span<const Index> list) {
    constexpr FlatPoint kSectorBegins[] = {{0.95630475596303544, 0.29237170472273677},
                                           {0.22495105434386500, 0.97437006478523525},
                                           {-0.73135370161917048, 0.68199836006249848}};
    constexpr unsigned kAllSectors = 6;
    if (list.size() < kAllSectors) return false;
    const Vec3 first = position[list[0]] - position[p];
    const Vec3 x = first - glm::dot(first, normal) * normal;
    const Vec3 y = glm::cross(normal, x);
    unsigned sectors = 0;  // Of the eight combinations of sides, six occur.
    for (const Index q : list) {
        const Vec3 offset = position[q] - position[p];
        const FlatPoint along{glm::dot(x, offset), glm::dot(y, offset)};
        if (along == FlatPoint(0.0)) continue;
        unsigned sides = 0;
        for (const FlatPoint& line : kSectorBegins)
            sides = 2 * sides + (line.x * along.y - line.y * along.x >= 0.0 ? 1U : 0U);
        sectors |= 1U << sides;
    }
    return std::popcount(sectors) == kAllSectors;
}

/// The widest gap at p, of any width.
Gap widestGap(std::span<const Vec3> position, std::span<const Vec3> normal,
              const NeighborLists& lists, Index p) {
    const auto list = lists[p];
    if (list.empty()) return {};
    return Spokes(position, normal[p], p, list[0], list).widest(kFullTurnOfKeys, kNone);
}

/// Share of the symmetric lists in the work; the rest is the search for gaps.
constexpr double kListsShare = 0.4;
/// Least number of points per thread.
constexpr std::size_t kPerThread = 2048;

class RimSearch {
  public:
    RimSearch(std::span<const Vec3> position, std::span<const Vec3> normal,
              const NeighborLists& lists, std::span<const std::uint8_t> type)
        : position_(position), normal_(normal), lists_(lists), type_(type) {}

    Result<Rim> run(unsigned threads, const Progress& progress) {
        if (!findCandidates(threads, progress)) return Error{"the search for rims was cancelled"};
        rim_.gap.assign(position_.size(), {});
        place_.assign(position_.size(), kNone);
        walked_.assign(lists_.ids.size(), false);
        for (Index p = 0; p < position_.size(); ++p) {
            if (candidate(p) && !rim_.gap[p].known()) follow(p);
        }
        addBetween();
        return std::move(rim_);
    }

  private:
    bool candidate(Index p) const { return widest_[p].key > kKey120; }
    bool onWall(Index p) const { return !type_.empty() && isOnWall(type_[p]); }

    /// False if cancelled. Gaps are found independently; the walks from them are cheap.
    bool findCandidates(unsigned threads, const Progress& progress) {
        widest_.resize(position_.size());
        const auto look = [this](std::size_t i) {
            const auto p = static_cast<Index>(i);
            if (isSurrounded(position_, normal_[p], p, lists_[p])) return;
            widest_[p] = widestGap(position_, normal_, lists_, p);
        };
        if (!forEachWithProgress(widest_.size(), threads, kPerThread, progress, look)) return false;
        for (Index p = 0; p < position_.size(); ++p) rim_.candidates += candidate(p) ? 1U : 0U;
        return true;
    }

    /// The step after p of a walk that came from `before`; kNone if there is none.
    Index next(Index before, Index p) const {
        Spokes spokes(position_, normal_[p], p, before, lists_[p]);
        spokes.turnBack();
        const Gap gap = spokes.widest(kKey150, before);
        return gap.key >= kKey60 ? gap.ends.to : kNone;
    }

    /// Marks the step from p to q as walked; false if it was already.
    bool mark(Index p, Index q) {
        const auto list = lists_[p];
        const auto at = std::find(list.begin(), list.end(), q) - list.begin();
        const std::size_t step = lists_.offset[p] + static_cast<std::size_t>(at);
        const bool first = !walked_[step];
        walked_[step] = true;
        return first;
    }

    /// Walks from candidate p until the walk closes or ends.
    void follow(Index p) {
        std::vector<Index> path{p};
        place_[p] = 0;
        Index q = widest_[p].ends.to;
        while (q != kNone && mark(path.back(), q) && place_[q] == kNone) {
            place_[q] = static_cast<Index>(path.size());
            path.push_back(q);
            q = next(path[path.size() - 2], q);
        }
        const Index closedAt = q != kNone ? place_[q] : kNone;
        for (const Index x : path) place_[x] = kNone;
        if (closedAt == kNone) return;
        path.erase(path.begin(), path.begin() + closedAt);
        if (isOpen(path)) take(std::move(path));
    }

    bool isOpen(const std::vector<Index>& chain) const {
        std::size_t candidates = 0;
        std::size_t walls = 0;
        for (const Index p : chain) {
            candidates += candidate(p) ? 1U : 0U;
            walls += onWall(p) ? 1U : 0U;
        }
        return 3 * candidates >= kOfThree * chain.size() && 2 * walls <= chain.size() &&
               shapeOfLoop(position_, normal_, chain).widthInEdges() >= kNarrowestOpening;
    }

    void take(std::vector<Index> chain) {
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const Index before = chain[i > 0 ? i - 1 : chain.size() - 1];
            const Index after = chain[i + 1 < chain.size() ? i + 1 : 0];
            if (!onWall(chain[i])) rim_.gap[chain[i]] = {before, after};
        }
        rim_.chains.push_back(std::move(chain));
    }

    /// Inserts candidates beside a chain that skipped them: those whose gap lies between two
    /// successive points of it.
    void addBetween() {
        std::vector<bool> onChain(position_.size(), false);
        for (const auto& chain : rim_.chains) {
            for (const Index p : chain) onChain[p] = true;
        }
        for (Index p = 0; p < position_.size(); ++p) {
            const RimGap& ends = widest_[p].ends;
            if (onChain[p] || onWall(p) || !candidate(p)) continue;
            if (!onChain[ends.from] || !onChain[ends.to]) continue;
            rim_.gap[p] = ends;
            if (rim_.gap[ends.from].to != ends.to || rim_.gap[ends.to].from != ends.from) continue;
            rim_.gap[ends.from].to = p;
            rim_.gap[ends.to].from = p;
            putOnChain(p);
        }
    }
    void putOnChain(Index p) {
        const RimGap& ends = rim_.gap[p];
        for (auto& chain : rim_.chains) {
            for (std::size_t i = 0; i < chain.size(); ++i) {
                const std::size_t next = i + 1 < chain.size() ? i + 1 : 0;
                if (chain[i] != ends.from || chain[next] != ends.to) continue;
                chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(i) + 1, p);
                return;
            }
        }
    }

    std::span<const Vec3> position_, normal_;
    const NeighborLists& lists_;
    std::span<const std::uint8_t> type_;
    Rim rim_;
    std::vector<Gap> widest_;   ///< Per point that is not surrounded.
    std::vector<Index> place_;  ///< Position of each point on the current path, else kNone.
    std::vector<bool> walked_;  ///< Per list entry: the step to it.
};

}  // namespace

std::size_t Rim::points() const {
    return static_cast<std::size_t>(
        std::count_if(gap.begin(), gap.end(), [](const RimGap& g) { return g.known(); }));
}

Result<Rim> findRim(std::span<const Vec3> position, std::span<const Vec3> normal,
                    const NeighborLists& neighbors, std::span<const std::uint8_t> type,
                    unsigned threads, const Progress& progress) {
    const Result<NeighborLists> lists = symmetricLists(
        position, neighbors, threads, partOf(progress, 0.0, kListsShare), kNearestOfRim);
    if (!lists) return lists.error();
    return RimSearch(position, normal, lists.value(), type)
        .run(threads, partOf(progress, kListsShare, 1.0));
}

Result<std::vector<RimGap>> gapsOfRimPoints(std::span<const Vec3> position,
                                            std::span<const Vec3> normal,
                                            const NeighborLists& neighbors,
                                            std::span<const std::uint8_t> type, unsigned threads,
                                            const Progress& progress) {
    const Result<NeighborLists> lists = symmetricLists(
        position, neighbors, threads, partOf(progress, 0.0, kListsShare), kNearestOfRim);
    if (!lists) return lists.error();
    std::vector<RimGap> gap(position.size());
    const auto look = [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        if (isRimPoint(type[p])) gap[p] = widestGap(position, normal, lists.value(), p).ends;
    };
    if (!forEachWithProgress(gap.size(), threads, kPerThread, partOf(progress, kListsShare, 1.0),
                             look))
        return Error{"the search for rims was cancelled"};
    return gap;
}

}  // namespace se
