/// Failures at the event that causes them, by incremental structures: a hash of edges, a hash of
/// corner triples, and a hash of grid cells for pairs; fans are checked when a point becomes
/// DONE, since it gets no triangles after that. About O(1) per triangle.
#include "spiraling_edge/run/live_check.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/geometry/second_layer.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/run/reading.h"

namespace se {
namespace {

/// Cells are as wide as this many mean distances of neighbors.
constexpr double kCell = 1.5;
/// Number of points whose lists give the mean distance.
constexpr std::size_t kSampled = 512;

double meanNeighborDistance(const PointSet& points) {
    double sum = 0.0;
    std::size_t count = 0;
    const std::size_t stride = std::max<std::size_t>(1, points.size() / kSampled);
    for (std::size_t p = 0; p < points.size(); p += stride) {
        for (const Index q : points.neighbors[static_cast<Index>(p)]) {
            const Vec3 d = points.position[q] - points.position[p];
            sum += std::sqrt(glm::dot(d, d));
            ++count;
        }
    }
    return sum > 0.0 ? sum / static_cast<double>(count) : 1.0;
}

Vec3 lowerCorner(const PointSet& points) {
    Vec3 low(0.0);
    bool any = false;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (points.neighbors[static_cast<Index>(p)].empty()) continue;  // possibly not finite
        low = any ? glm::min(low, points.position[p]) : points.position[p];
        any = true;
    }
    return low;
}

std::uint64_t pairKey(Index u, Index v) {
    return (std::uint64_t{std::min(u, v)} << 32U) | std::max(u, v);
}

std::array<Index, 3> sortedCorners(const Triangle& t) {
    std::array<Index, 3> corners{t.a, t.b, t.c};
    std::sort(corners.begin(), corners.end());
    return corners;
}

struct CornersHash {
    std::size_t operator()(const std::array<Index, 3>& c) const {
        const std::uint64_t low = (std::uint64_t{c[0]} << 32U) | c[1];
        return std::hash<std::uint64_t>()(low * 0x9e3779b97f4a7c15U + c[2]);
    }
};

/// The triangles at an edge.
struct EdgeUse {
    Index first = kNone;                          ///< The first triangle at it.
    std::array<Index, 2> firstWay{kNone, kNone};  ///< The first of each direction.
    std::uint32_t triangles = 0;
};

}  // namespace

class LiveCheck::Checker {
  public:
    explicit Checker(const PointSet& points)
        : points_(points),
          cells_(lowerCorner(points), kCell * meanNeighborDistance(points)),
          used_(points.size(), false),
          trianglesAt_(points.size()) {}

    /// Takes the triangles from before the run, whose failures are not reported.
    void take(std::span<const Triangle> given) {
        std::vector<LiveFailure> notOfTheRun;
        found_ = &notOfTheRun;
        for (const Triangle& each : given) checkTriangle(each);
        found_ = nullptr;
    }

    void check(const Event& event, std::vector<LiveFailure>& found) {
        found_ = &found;
        address_ = event.address;
        if (const auto* emit = as<EmitEvidence>(event)) {
            checkTriangle(emit->corners);
        } else if (const auto* strand = as<StrandEvidence>(event)) {
            checkDone(strand->point);
        } else if (const auto* ring = as<RingEvidence>(event)) {
            if (ring->status < 0) checkDone(ring->point);
        }
    }

    bool searchesAll() const { return !exhausted_; }

  private:
    void checkDone(Index p) {
        if (!used_[p]) add("lost_points", kNone, kNone, {p});
        if (!isOneFan(p)) add("non_manifold_vertices", kNone, kNone, {p});
        freeList(trianglesAt_[p]);  // A DONE point gets no more triangles (§4).
    }

    /// True if the triangles at a point are connected by edges. One with that point twice is not.
    bool isOneFan(Index p) const {
        const std::vector<Index>& all = trianglesAt_[p];
        DisjointSets fans(all.size());
        std::size_t joined = 0;
        std::unordered_map<Index, std::size_t> firstAt;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Triangle& t = triangles_[all[i]];
            if ((t.a == p) + (t.b == p) + (t.c == p) != 1) return false;
            for (const Index q : {t.a, t.b, t.c}) {
                if (q == p) continue;
                const auto [at, fresh] = firstAt.try_emplace(q, i);
                if (!fresh && fans.unite(static_cast<Index>(at->second), static_cast<Index>(i)))
                    ++joined;
            }
        }
        return joined + 1 >= all.size();
    }

    void checkTriangle(const Triangle& made) {
        const auto number = static_cast<Index>(triangles_.size());
        triangles_.push_back(made);
        boxes_.push_back(boxOf(points_, made));
        shapes_.push_back(layerShape(points_, made));
        wide_.push_back(conflictBox(boxes_.back(), shapes_.back()));
        metBy_.push_back(kNone);
        used_[made.a] = used_[made.b] = used_[made.c] = true;
        for (const Index p : {made.a, made.b, made.c}) trianglesAt_[p].push_back(number);
        const bool area = !isDegenerate(points_, made);
        hasArea_.push_back(area);
        checkEdges(number);
        const auto [same, fresh] = byCorners_.try_emplace(sortedCorners(made), number);
        if (!fresh) addPair("duplicate_triangles", number, same->second);
        if (!area) return addPair("degenerate_triangles", number, number);
        checkPairs(number, fresh);
        if (isFlipped(points_, made)) addPair("flipped_triangles", number, number);
    }

    void checkEdges(Index number) {
        const Triangle& t = triangles_[number];
        Index fold = kNone;
        bool manyTold = false;
        bool wayTold = false;
        for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
            EdgeUse& use = edges_[pairKey(u, v)];
            const std::size_t way = u < v ? 0 : 1;
            const std::vector<Index> edge{std::min(u, v), std::max(u, v)};
            if (use.triangles == 2 && !std::exchange(manyTold, true))
                add("non_manifold_edges", number, use.first, edge);
            if (use.firstWay[way] != kNone && !std::exchange(wayTold, true))
                add("inconsistent_edges", number, use.firstWay[way], edge);
            if (use.triangles == 1 && use.firstWay[way] == kNone && fold == kNone &&
                hasArea_[number] && hasArea_[use.first] &&
                folded(points_, triangles_[use.first], t))
                fold = use.first;
            if (use.triangles++ == 0) use.first = number;
            if (use.firstWay[way] == kNone) use.firstWay[way] = number;
        }
        if (fold != kNone) addPair("folded_edges", number, fold);
    }

    /// Tests a new triangle against all earlier ones nearby until it crosses one and is a second
    /// layer of one, then adds it to them. A copy (not `fresh`) is not added: the first of its kind
    /// meets the same triangles.
    void checkPairs(Index number, bool fresh) {
        allowed_ += kLiveCheckWorkPerTriangle;
        // Permanently, since the triangles skipped meanwhile are in no cell.
        exhausted_ = exhausted_ || work_ > allowed_;
        if (exhausted_) return;
        const Box& box = wide_[number];
        near_.clear();
        const auto meet = [&](Index other) {
            ++work_;
            // A triangle lies in many cells, but is tested once.
            if (std::exchange(metBy_[other], number) != number) near_.push_back(other);
        };
        const bool fits = cells_.forEachCell(box.low, box.high, [&](std::uint64_t cell) {
            std::vector<Index>& there = inCell_[cell];
            std::for_each(there.begin(), there.end(), meet);
            if (fresh) there.push_back(number);
        });
        std::for_each(large_.begin(), large_.end(), meet);
        if (!fits) {
            for (Index i = 0; i < number; ++i) meet(i);
            if (fresh) large_.push_back(number);
        }
        std::sort(near_.begin(), near_.end());
        bool crosses = false;
        bool covers = false;
        for (const Index other : near_) {
            if (crosses && covers) return;
            if (!hasArea_[other] || !wide_[other].meets(box)) continue;
            if (!covers && isSecondLayer(points_, triangles_[other], shapes_[other],
                                         triangles_[number], shapes_[number])) {
                covers = true;
                addPair("second_layers", number, other);
            }
            if (crosses || !boxes_[other].meets(boxes_[number])) continue;
            work_ += kPairTestWork;
            if (!trianglesShareMore(points_.position, triangles_[other], triangles_[number]))
                continue;
            crosses = true;
            addPair("intersecting_triangles", number, other);
        }
    }

    void addPair(std::string_view kind, Index number, Index other) {
        std::vector<Index> points;
        for (const Index i : {number, other}) {
            const Triangle& t = triangles_[i];
            points.insert(points.end(), {t.a, t.b, t.c});
        }
        sortUnique(points);
        add(kind, number, other == number ? kNone : other, std::move(points));
    }
    void add(std::string_view kind, Index number, Index other, std::vector<Index> points) {
        found_->push_back({findFailureClass(kind), address_, number, other, std::move(points)});
    }

    const PointSet& points_;
    BoxCells cells_;
    std::vector<bool> used_;
    std::vector<std::vector<Index>> trianglesAt_;  ///< Of points that are not DONE.
    std::vector<Triangle> triangles_;
    std::vector<Box> boxes_;
    std::vector<LayerShape> shapes_;
    std::vector<Box> wide_;  ///< conflictBox() of each triangle.
    std::vector<bool> hasArea_;
    std::unordered_map<std::uint64_t, EdgeUse> edges_;
    std::unordered_map<std::array<Index, 3>, Index, CornersHash> byCorners_;
    std::unordered_map<std::uint64_t, std::vector<Index>> inCell_;
    std::vector<Index> large_;  ///< Triangles over too many cells.
    std::vector<Index> near_;   ///< Those near one triangle; a member to reuse its memory.
    std::vector<Index> metBy_;  ///< Per triangle: the last one that it was near to.
    std::uint64_t work_ = 0;    ///< Triangles visited in the search for pairs.
    std::uint64_t allowed_ = kLiveCheckWork;
    bool exhausted_ = false;
    std::vector<LiveFailure>* found_ = nullptr;
    Address address_;
};

LiveCheck::LiveCheck(const PointSet& points, const GivenStart& start)
    : checker_(std::make_unique<Checker>(points)) {
    assert(validate(points).ok());
    checker_->take(start.triangles);
}
LiveCheck::~LiveCheck() = default;
LiveCheck::LiveCheck(LiveCheck&&) noexcept = default;
LiveCheck& LiveCheck::operator=(LiveCheck&&) noexcept = default;

std::vector<LiveFailure> LiveCheck::check(std::span<const Event> events) {
    std::vector<LiveFailure> found;
    for (const Event& event : events) checker_->check(event, found);
    return found;
}

bool LiveCheck::complete() const { return checker_->searchesAll(); }

std::string describe(const LiveFailure& failure) {
    const std::string names = joinedNumbers(failure.points);
    const std::string_view kind = failure.kind->name;
    const std::string made = "Triangle " + std::to_string(failure.triangle);
    const std::string other = std::to_string(failure.other);
    if (kind == "lost_points") return "Point " + names + " is DONE and in no triangle.";
    if (kind == "non_manifold_vertices")
        return "The triangles about point " + names + " are more than one fan.";
    if (kind == "non_manifold_edges")
        return made + " is the third at the edge " + names + ": non-manifold.";
    if (kind == "inconsistent_edges")
        return made + " passes the edge " + names + " in the same direction as " + other + ".";
    if (kind == "duplicate_triangles")
        return made + " has the points of " + other + ": a duplicate.";
    if (kind == "degenerate_triangles") return made + " is a needle, or has a corner twice.";
    if (kind == "flipped_triangles") return made + " faces away from the normals of its points.";
    if (kind == "second_layers") return made + " is a second layer of " + other + ".";
    if (kind == "folded_edges") return made + " lies folded onto " + other + ".";
    return made + " overlaps " + other + ": they share more than their common corners.";
}

}  // namespace se
