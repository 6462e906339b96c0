#include "spiraling_edge/prepare.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "finite.h"
#include "prepare_neighbors.h"
#include "spiraling_edge/normals.h"

namespace se {
namespace {

/// Normals off by less than this from unit length are left bit for bit as they are.
constexpr double kUnitTolerance = 1e-12;
/// Normals off by more than this are reported: less is what few digits in a file bring about.
constexpr double kReportedTolerance = 1e-3;

/// Positions already seen, for finding exact copies: open addressing, each slot a point or kNone.
class PositionTable {
  public:
    explicit PositionTable(const std::vector<Vec3>& position) : position_(position) {
        std::size_t slots = 16;
        while (slots < 2 * position.size()) slots *= 2;
        slots_.assign(slots, kNone);
    }

    /// Adds point p. False if another point at the same place was added before.
    bool add(Index p) {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash(position_[p]) & mask;; slot = (slot + 1) & mask) {
            if (slots_[slot] == kNone) {
                slots_[slot] = p;
                return true;
            }
            if (position_[slots_[slot]] == position_[p]) return false;
        }
    }

  private:
    static std::size_t hash(const Vec3& v) {
        std::uint64_t h = 0;
        for (const double coordinate : {v.x, v.y, v.z}) {
            const double unsignedZero = coordinate + 0.0;  // -0 equals 0, so it must hash like it
            std::uint64_t bits = 0;
            std::memcpy(&bits, &unsignedZero, sizeof bits);
            h = (h ^ bits) * 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio: spreads low bits upwards
            h ^= h >> 32U;
        }
        return static_cast<std::size_t>(h);
    }

    const std::vector<Vec3>& position_;
    std::vector<Index> slots_;
};

/// Seconds since the last lap.
class Laps {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Turns one PointFile into one PointSet.
class Preparation {
  public:
    Preparation(const PointFile& file, const PrepareOptions& options, const Progress& progress)
        : file_(file), options_(options), progress_(progress) {}

    Result<Prepared> run() {
        if (Status status = checkInput(); !status) return status.error();
        set_.position = file_.position;
        takeTypes();
        setAsideCopies();
        if (Status status = makeNormals(); !status) return status.error();
        Result<NeighborLists> lists = makeLists();
        if (!lists) return lists.error();
        set_.neighbors = std::move(lists.value());
        assert(validate(set_).ok());
        return std::move(prepared_);
    }

  private:
    Status checkInput() const {
        const std::size_t n = file_.position.size();
        if (n >= kNone)
            return Error{"there are " + std::to_string(n) +
                         " points; at most 4294967294 are possible"};
        const auto fits = [n](std::size_t size) { return size == 0 || size == n; };
        if (!fits(file_.normal.size()) || !fits(file_.type.size()) ||
            !fits(file_.neighbors.size())) {
            return Error{"normals, types or neighbor lists are not as many as the points"};
        }
        return success();
    }

    void takeTypes() {
        Laps watch;
        if (options_.walls) {
            set_.type = wallTypes(file_.position, *options_.walls);
            report_.derived.types = true;
            report_.derived.typeSeconds = watch.lap();
            return;
        }
        set_.type.assign(file_.position.size(), kInterior);
        std::transform(file_.type.begin(), file_.type.end(), set_.type.begin(), withCornerBit);
    }

    /// Points that nothing can be derived from.
    void setAsideCopies() {
        const auto n = static_cast<Index>(set_.size());
        usable_.assign(n, false);
        PositionTable seen(set_.position);
        for (Index p = 0; p < n; ++p) {
            if (!isFinite(set_.position[p])) {
                ++report_.nonFinitePoints;
            } else if (derivesNormals() || hasDirection(file_.normal[p])) {
                usable_[p] = seen.add(p);
                if (!usable_[p]) ++report_.duplicatePoints;
            } else {
                ++report_.zeroNormals;
            }
        }
    }

    bool derivesNormals() const {
        return !file_.hasNormals() || options_.normals == NormalSource::Derived;
    }

    Status makeNormals() {
        if (!derivesNormals()) {
            set_.normal = file_.normal;
            for (Index p = 0; p < set_.size(); ++p) {
                if (isFinite(set_.position[p])) normalize(set_.normal[p]);
            }
            if (options_.normals == NormalSource::AsGiven) return success();
        }
        Laps watch;
        Result<NeighborLists> lists = listsForNormals();
        if (!lists) return lists.error();
        DerivedPieces& derived = report_.derived;
        if (derivesNormals()) {
            set_.normal = estimateNormals(set_.position, lists.value());
            setAsidePlaneless();
            derived.normals = true;
            derived.normalSeconds = watch.lap();
        }
        const OrientationReport turned = orientNormals(set_.position, lists.value(), set_.normal);
        derived.orientation = true;
        derived.turnedNormals = derivesNormals() ? 0 : turned.turned;
        derived.normalComponents = turned.components;
        derived.orientationSeconds = watch.lap();
        return success();
    }

    /// The nearest, whatever their normals.
    Result<NeighborLists> listsForNormals() {
        NeighborOptions nearest = options_.neighbors;
        nearest.reach = KNearest{options_.planeNeighbors};
        nearest.dropOpposingNormals = false;
        return findNeighbors(set_.position, {}, usable_, nearest, part(0.0, kNormalShare));
    }

    void setAsidePlaneless() {
        for (Index p = 0; p < set_.size(); ++p) {
            if (!usable_[p] || set_.normal[p] != Vec3(0.0)) continue;
            usable_[p] = false;
            ++report_.derived.planelessPoints;
        }
    }

    /// Of the progress, from `from` to `to`.
    Progress part(double from, double to) const {
        if (!progress_) return {};
        return [this, from, to](double share) { return progress_(from + (to - from) * share); };
    }

    static bool hasDirection(const Vec3& normal) { return isFinite(normal) && normal != Vec3(0.0); }

    /// Scales `normal` to unit length; one without direction is left as it is.
    void normalize(Vec3& normal) {
        if (!hasDirection(normal)) return;
        const double length = glm::length(normal);
        if (std::abs(length - 1.0) <= kUnitTolerance) return;
        // By the largest component first: squares of very long or short normals leave the range.
        const double largest =
            std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
        normal /= largest;
        normal /= glm::length(normal);
        if (!(std::abs(length - 1.0) <= kReportedTolerance)) ++report_.unscaledNormals;
    }

    Result<NeighborLists> makeLists() {
        const NeighborOptions& neighbors = options_.neighbors;
        if (file_.hasNeighbors() && !neighbors.recompute) return cleanLists();
        report_.neighborsComputed = true;
        Laps watch;
        const double from = report_.derived.orientation ? kNormalShare : 0.0;
        Result<NeighborLists> lists =
            findNeighbors(set_.position, set_.normal, usable_, neighbors, part(from, 1.0));
        report_.derived.neighborSeconds = watch.lap();
        return lists;
    }

    Result<NeighborLists> cleanLists() {
        const auto n = static_cast<Index>(set_.size());
        NeighborLists lists;
        lists.offset.reserve(std::size_t{n} + 1);
        std::vector<Neighbor> kept;
        std::vector<Index> ids;
        for (Index p = 0; p < n; ++p) {
            kept.clear();
            for (const Index q : file_.neighbors[p]) {
                if (q >= n) {
                    return Error{"the neighbor list of point " + std::to_string(p) +
                                 " names point " + std::to_string(q) + ", but there are " +
                                 std::to_string(n) + " points; correct the list or leave it out"};
                }
                if (mayNeighbor(p, q)) {
                    kept.push_back({distanceSquared(set_.position[p], set_.position[q]), q});
                }
            }
            std::sort(kept.begin(), kept.end());
            // Equal points have equal distances, so copies stand side by side now.
            kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
            ids.clear();
            for (const Neighbor& neighbor : kept) ids.push_back(neighbor.id);
            lists.append(ids);
            report_.droppedListEntries += file_.neighbors[p].size() - ids.size();
        }
        return lists;
    }

    /// Points at distance zero are not usable, so they need no test of their own.
    bool mayNeighbor(Index p, Index q) const {
        if (q == p || !usable_[p] || !usable_[q]) return false;
        return !options_.neighbors.dropOpposingNormals ||
               !normalsOppose(set_.normal[p], set_.normal[q]);
    }

    /// Of the whole work, when normals are derived.
    static constexpr double kNormalShare = 0.5;

    const PointFile& file_;
    const PrepareOptions& options_;
    const Progress& progress_;
    Prepared prepared_;
    PointSet& set_ = prepared_.points;
    PrepareReport& report_ = prepared_.report;
    std::vector<bool> usable_;
};

}  // namespace

Result<Prepared> prepare(const PointFile& file, const PrepareOptions& options,
                         const Progress& progress) {
    if (const Status status = checkReach(options.neighbors); !status) return status.error();
    return Preparation(file, options, progress).run();
}

}  // namespace se
