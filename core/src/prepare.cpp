#include "spiraling_edge/prepare.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <string>
#include <utility>

#include "prepare_neighbors.h"
#include "spiraling_edge/noise.h"
#include "spiraling_edge/normals.h"
#include "usable_points.h"

namespace se {
namespace {

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
        if (Status status = checkColumns(file_); !status) return status.error();
        set_.position = file_.position;
        takeTypes();
        setAsideCopies();
        if (Status status = makeNormals(); !status) return status.error();
        Result<NeighborLists> lists = makeLists();
        if (!lists) return lists.error();
        if (options_.neighbors.symmetric) lists = symmetricLists(set_.position, lists.value());
        if (!lists) return lists.error();
        set_.neighbors = std::move(lists.value());
        assert(validate(set_).ok());
        return std::move(prepared_);
    }

  private:
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
        const std::vector<Fitness> fitness =
            fitnessOf(set_.position, derivesNormals() ? std::span<const Vec3>{} : file_.normal);
        usable_.resize(fitness.size());
        for (std::size_t p = 0; p < fitness.size(); ++p) {
            usable_[p] = fitness[p] == Fitness::Usable;
            if (fitness[p] == Fitness::NonFinite) ++report_.nonFinitePoints;
            if (fitness[p] == Fitness::NoDirection) ++report_.zeroNormals;
            if (fitness[p] == Fitness::Copy) ++report_.duplicatePoints;
        }
    }

    bool derivesNormals() const {
        return !file_.hasNormals() || options_.normals == NormalSource::Derived;
    }

    Status makeNormals() {
        if (!derivesNormals()) {
            set_.normal = file_.normal;
            for (Index p = 0; p < set_.size(); ++p) {
                if (isFinite(set_.position[p]) && scaleToUnit(set_.normal[p]))
                    ++report_.unscaledNormals;
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

    Result<NeighborLists> makeLists() {
        const NeighborOptions& neighbors = options_.neighbors;
        if (file_.hasNeighbors() && !neighbors.recompute) return cleanLists();
        report_.neighborsComputed = true;
        Laps watch;
        const double from = report_.derived.orientation ? kNormalShare : 0.0;
        Result<NeighborLists> lists =
            findNeighbors(set_.position, set_.normal, usable_, neighbors, part(from, 1.0));
        if (lists && options_.setNoiseAside) lists = withoutNoise(std::move(lists));
        report_.derived.neighborSeconds = watch.lap();
        return lists;
    }

    /// The lists again, without the points that noise scatters over and under the others. If it is
    /// still there then, the points are no surface, or one that bends as fast as it is noisy: all
    /// stay.
    Result<NeighborLists> withoutNoise(Result<NeighborLists> all) {
        const auto noiseOf = [&](const Result<NeighborLists>& lists) {
            return noiseAlongNormals(set_.position, set_.normal, lists.value());
        };
        report_.noise = noiseOf(all);
        if (report_.noise <= kNoisy) return all;
        const std::vector<bool> usable = usable_;
        NeighborOptions wide = options_.neighbors;
        wide.reach = KNearest{kNoisePatch};
        Result<NeighborLists> lists =
            findNeighbors(set_.position, set_.normal, usable_, wide, part(kNormalShare, 1.0));
        if (!lists) return lists;
        const auto patches = noisePatches(set_.position, set_.normal, lists.value(), usable_);
        while (const std::size_t aside =
                   setNoiseAside(set_.position, patches, lists.value(), usable_)) {
            report_.noisyPoints += aside;
            lists = findNeighbors(set_.position, set_.normal, usable_, wide);
            if (!lists) return lists;
        }
        const std::vector<Vec3> normal = set_.normal;
        for (Index p = 0; p < set_.size(); ++p) {
            if (usable_[p]) set_.normal[p] = patches[p].normal;
        }
        lists = findNeighbors(set_.position, set_.normal, usable_, options_.neighbors);
        if (!lists || noiseOf(lists) <= kNoisy) return lists;
        usable_ = usable;
        set_.normal = normal;
        report_.noisyPoints = 0;
        return all;
    }

    Result<NeighborLists> cleanLists() {
        const auto n = static_cast<Index>(set_.size());
        NeighborLists lists;
        lists.offset.reserve(std::size_t{n} + 1);
        std::vector<Index> kept;
        for (Index p = 0; p < n; ++p) {
            kept.clear();
            for (const Index q : file_.neighbors[p]) {
                if (q >= n) {
                    return Error{"the neighbor list of point " + std::to_string(p) +
                                 " names point " + std::to_string(q) + ", but there are " +
                                 std::to_string(n) + " points; correct the list or leave it out"};
                }
                if (mayNeighbor(p, q)) kept.push_back(q);
            }
            sortNearestFirst(set_.position, p, kept);
            lists.append(kept);
            report_.droppedListEntries += file_.neighbors[p].size() - kept.size();
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
